// SPDX-License-Identifier: GPL-3.0-or-later
// Curves in shells that are built near them alone.
#include "bspline_curve/designer.h"
#include "curve_checks.h"
#include "design/designer_surface.h"
#include "either_shell.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

#include <future>
#include <utility>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

TriangleMesh bumpySphere() {
    return withNoise(icosphere(4), 0.004, 11);
}

std::vector<Vec3> fewPicks(const TriangleMesh& mesh) {
    return {mesh.vertices[5], mesh.vertices[100], mesh.vertices[400], mesh.vertices[900]};
}

TEST(LocalShell, GivesTheCurveOfTheWholeShell) {
    const TriangleMesh mesh = bumpySphere();
    const std::vector<Vec3> picks = fewPicks(mesh);
    const CurveDesigner local = designerIn(ShellKind::Local, mesh);
    const CurveDesigner full = designerIn(ShellKind::FullResolution, mesh);
    const Curve near = goodCurve(local, picks);
    const Curve whole = goodCurve(full, picks);
    EXPECT_EQ(near.spline.controlPoints, whole.spline.controlPoints);
    const double tolerance =
        SolverOptions().distanceTolerance * surfaceOf(full).averageEdgeLength();
    EXPECT_LT(largestDistance(near.polyline, whole.polyline), tolerance);
    EXPECT_EQ(whole.prisms, surfaceOf(full).faceCount());
    EXPECT_EQ(whole.shell, ShellKind::FullResolution);
    EXPECT_EQ(near.shell, std::nullopt);
    EXPECT_EQ(near.prisms, 0);
    EXPECT_GT(near.facesPassed, 0);
    EXPECT_LT(near.facesPassed, whole.prisms / 4);
}

// Integrals cell by cell take the whole shell, so everything is the same.
TEST(LocalShell, IsTheWholeOneForCurvesThatNeedIt) {
    const TriangleMesh mesh = bumpySphere();
    const std::vector<Vec3> picks = fewPicks(mesh);
    SolverOptions options;
    options.quadrature = Quadrature::Cells;
    const Curve near = designerIn(ShellKind::Local, mesh).design(picks, options);
    const Curve whole = designerIn(ShellKind::FullResolution, mesh).design(picks, options);
    EXPECT_EQ(near.polyline.points, whole.polyline.points);
    EXPECT_EQ(near.shell, ShellKind::FullResolution);
    EXPECT_EQ(near.prisms, whole.prisms);
}

TEST(LocalShell, DoesNotRememberOtherCurves) {
    const TriangleMesh mesh = bumpySphere();
    const std::vector<Vec3> picks = fewPicks(mesh);
    const CurveDesigner fresh = designerIn(ShellKind::Local, mesh);
    const CurveDesigner used = designerIn(ShellKind::Local, mesh);
    static_cast<void>(goodCurve(used, {mesh.vertices[50], mesh.vertices[300], mesh.vertices[900]}));
    SolverOptions cells;
    cells.quadrature = Quadrature::Cells;
    static_cast<void>(used.design(picks, cells));
    EXPECT_EQ(goodCurve(fresh, picks).polyline.points, goodCurve(used, picks).polyline.points);
}

TEST(LocalShell, ServesThreadsAtOnce) {
    const TriangleMesh mesh = bumpySphere();
    const std::vector<Vec3> picks = fewPicks(mesh);
    const CurveDesigner designer = designerIn(ShellKind::Local, mesh);
    SolverOptions cells;
    cells.quadrature = Quadrature::Cells;
    const auto draw = [&](const SolverOptions& options) {
        return designer.design(picks, options).polyline.points;
    };
    std::vector<std::future<std::vector<Vec3>>> relaxed;
    std::vector<std::future<std::vector<Vec3>>> inCells;
    for (int i = 0; i < 3; ++i) {
        relaxed.push_back(std::async(std::launch::async, draw, SolverOptions()));
        inCells.push_back(std::async(std::launch::async, draw, cells));
    }
    const std::vector<Vec3> first = draw({});
    const std::vector<Vec3> firstInCells = draw(cells);
    for (auto& each : relaxed) {
        EXPECT_EQ(each.get(), first);
    }
    for (auto& each : inCells) {
        EXPECT_EQ(each.get(), firstInCells);
    }
}

TEST(LocalShell, DrawsAlongBoundaries) {
    const TriangleMesh mesh = plate(20, 20);
    const std::vector<Vec3> picks = {{0.1, 0.0, 0.0}, {0.5, 0.02, 0.0}, {0.9, 0.0, 0.0}};
    const CurveDesigner local = designerIn(ShellKind::Local, mesh);
    const CurveDesigner full = designerIn(ShellKind::FullResolution, mesh);
    const Curve near = goodCurve(local, picks);
    const Curve whole = goodCurve(full, picks);
    EXPECT_EQ(near.spline.controlPoints, whole.spline.controlPoints);
    EXPECT_LT(largestDistance(near.polyline, whole.polyline), 1e-9);
}

}  // namespace
}  // namespace bspline_curve
