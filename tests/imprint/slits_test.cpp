// SPDX-License-Identifier: GPL-3.0-or-later
#include "imprint/slits.h"

#include "imprint/random_curves.h"
#include "support/many_cases.h"
#include "support/meshes.h"
#include "support/seeds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace bspline_curve {

namespace {

using namespace test_support;

constexpr int kCells = 8;

std::vector<std::array<int, 2>> row(int first, int last, int j) {
    std::vector<std::array<int, 2>> grid;
    for (int i = first; i <= last; ++i) {
        grid.push_back({i, j});
    }
    return grid;
}

Slits slits(const Surface& surface, const std::vector<SurfacePolyline>& curves) {
    const ImprintedMesh imprinted = imprint(surface, curves, {});
    return slitsOf(imprinted, partsOf(imprinted));
}

class Plate : public testing::Test {
protected:
    [[nodiscard]] SurfacePolyline along(
        const std::vector<std::array<int, 2>>& grid, bool closed = false
    ) const {
        return alongGrid(surface_, kCells, grid, closed);
    }

    [[nodiscard]] std::string note(const std::vector<SurfacePolyline>& curves) const {
        return describeSlits(slits(surface_, curves), true);
    }

    Surface surface_{plate(kCells, kCells)};
};

TEST_F(Plate, AnOpenCurveIsASlit) {
    const Slits found = slits(surface_, {along(row(2, 6, 3))});
    EXPECT_EQ(found.curves, 1);
    EXPECT_EQ(found.completeCurves, 0);
    EXPECT_EQ(found.edges, 4);
    EXPECT_EQ(
        describeSlits(found, true),
        "the curve parts nothing: the mesh is cut open along it (4 edges), a slit that is closed "
        "to the eye; draw a closed curve, or one from boundary to boundary, to part the mesh"
    );
}

TEST_F(Plate, WhereNothingIsCutTheNoteSaysNoMore) {
    EXPECT_EQ(
        describeSlits(slits(surface_, {along(row(2, 6, 3))}), false),
        "the curve parts nothing; draw a closed curve, or one from boundary to boundary, to part "
        "the mesh"
    );
}

TEST_F(Plate, WhatPartsIsNoSlit) {
    EXPECT_EQ(note({along(row(0, kCells, 3))}), "");  // from boundary to boundary
    EXPECT_EQ(note({along({{2, 2}, {3, 2}, {3, 3}, {2, 3}}, true)}), "");
    EXPECT_EQ(note({along(row(0, kCells, 0))}), "");  // along the boundary
    // Two open curves that bound a part between them, with ends that stick out.
    EXPECT_EQ(
        note(
            {along({{1, 2}, {2, 2}, {3, 2}, {4, 2}, {5, 2}, {5, 3}, {5, 4}}),
             along({{2, 1}, {2, 2}, {2, 3}, {3, 3}, {4, 3}, {5, 3}, {6, 3}})}
        ),
        ""
    );
}

TEST_F(Plate, CurvesThatPartNothingAreCountedAmongOthers) {
    const std::vector<SurfacePolyline> curves{
        along(row(1, 3, 6)), along({{2, 2}, {3, 2}, {3, 3}, {2, 3}}, true), along(row(5, 7, 6))
    };
    EXPECT_EQ(
        note(curves).substr(0, 70),
        "2 of 3 curves part nothing: the mesh is cut open along them (4 edges),"
    );
    // Edges of two curves at the same place count once.
    EXPECT_EQ(slits(surface_, {curves[0], curves[0]}).edges, 2);
    EXPECT_EQ(note({curves[0], curves[2]}).substr(0, 26), "the 2 curves part nothing:");
}

TEST(Slits, ACurveRoundAHandleNeedsASecondOne) {
    constexpr int kAround = 12;
    constexpr int kAcross = 6;
    const Surface surface(torus(kAround, kAcross));
    const auto ring = [&](int first) {
        std::vector<int> vertices;
        for (int j = 0; j < kAcross; ++j) {
            vertices.push_back(j * kAround + first);
        }
        return polylineAlong(surface, vertices, true);
    };
    const Slits one = slits(surface, {ring(0)});
    EXPECT_EQ(one.completeCurves, 1);
    EXPECT_EQ(one.edges, kAcross);
    EXPECT_NE(describeSlits(one, true).find("it takes two curves"), std::string::npos);
    EXPECT_EQ(slits(surface, {ring(0), ring(5)}).curves, 0);
}

TEST(Slits, OfRandomNetworksAreTheCurvesWithoutAPartingEdge) {
    for (const TriangleMesh& mesh : {plate(3, 3), icosphere(2), torus(14, 9), box(1)}) {
        const Surface surface(mesh);
        forEachSeed(caseCount(50, 4), [&](Random& random) {
            const ImprintedMesh imprinted = imprint(surface, randomCurves(surface, random), {});
            const MeshParts parts = partsOf(imprinted);
            const auto beside = [&](const std::array<int, 2>& edge) {
                std::vector<int> labels;
                for (std::size_t f = 0; f < imprinted.mesh.faces.size(); ++f) {
                    const Triangle& face = imprinted.mesh.faces[f];
                    if (std::ranges::count(face, edge[0]) + std::ranges::count(face, edge[1]) ==
                        2) {
                        labels.push_back(parts.labels[f]);
                    }
                }
                return labels;
            };
            int curves = 0;
            for (const ImprintedCurve& curve : imprinted.curves) {
                bool isSlit = false;
                bool isParting = false;
                for (const auto& edge : edgesOf(curve)) {
                    const std::vector<int> labels = beside(edge);
                    isSlit = isSlit || (labels.size() == 2 && labels[0] == labels[1]);
                    isParting = isParting || (labels.size() == 2 && labels[0] != labels[1]);
                }
                curves += isSlit && !isParting ? 1 : 0;
            }
            ASSERT_EQ(slitsOf(imprinted, parts).curves, curves);
        });
    }
}

}  // namespace

}  // namespace bspline_curve
