// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/handmade_shell.h"
#include "shell/shell_builder.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

namespace bspline_curve::io_tests {

/// A small simplified shell with a report, to be stored.
inline test_support::HandmadeShell smallShell(double halfThickness = 0.3) {
    const TriangleMesh sphere = test_support::icosphere(0);
    test_support::HandmadeShell shell(sphere, test_support::icosphere(1), halfThickness);
    shell.blockedFaces = {3, 17};
    shell.track();
    return shell;
}

inline ShellBuild buildOf(const test_support::HandmadeShell& shell) {
    return {
        .shell = shell.shell(),
        .report = {
            .orientationRounds = 3,
            .intersectionRounds = 5,
            .blockedFaces = shell.blockedFaces,
            .selfIntersections = {{3, 17}, {3, 19}}
        }
    };
}

inline void expectSame(const ShellBuild& a, const ShellBuild& b) {
    ASSERT_EQ(a.shell.pillars().size(), b.shell.pillars().size());
    for (std::size_t i = 0; i < a.shell.pillars().size(); ++i) {
        EXPECT_EQ(a.shell.pillars()[i].bottom, b.shell.pillars()[i].bottom);
        EXPECT_EQ(a.shell.pillars()[i].middle, b.shell.pillars()[i].middle);
        EXPECT_EQ(a.shell.pillars()[i].top, b.shell.pillars()[i].top);
    }
    ASSERT_EQ(a.shell.prisms().size(), b.shell.prisms().size());
    for (std::size_t i = 0; i < a.shell.prisms().size(); ++i) {
        const Prism& p = a.shell.prisms()[i];
        const Prism& q = b.shell.prisms()[i];
        EXPECT_EQ(p.pillars, q.pillars);
        EXPECT_EQ(p.neighbours, q.neighbours);
        EXPECT_EQ(p.faceCorner, q.faceCorner);
        EXPECT_EQ(p.neighbourWalls, q.neighbourWalls);
        EXPECT_EQ(p.orientation, q.orientation);
    }
    EXPECT_EQ(a.shell.tracks().offsets, b.shell.tracks().offsets);
    EXPECT_EQ(a.shell.tracks().faces, b.shell.tracks().faces);
    EXPECT_EQ(a.report.orientationRounds, b.report.orientationRounds);
    EXPECT_EQ(a.report.intersectionRounds, b.report.intersectionRounds);
    EXPECT_EQ(a.report.blockedFaces, b.report.blockedFaces);
    EXPECT_EQ(a.report.selfIntersections, b.report.selfIntersections);
}

}  // namespace bspline_curve::io_tests
