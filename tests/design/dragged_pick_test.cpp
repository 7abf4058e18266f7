// SPDX-License-Identifier: GPL-3.0-or-later
// Curves that start from one through picks nearby, as while a pick is dragged.
#include "bspline_curve/designer.h"
#include "curve_checks.h"
#include "design/designer_surface.h"
#include "either_shell.h"
#include "support/meshes.h"
#include "surface/triangle_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

class DraggedPick : public EitherShell {
protected:
    // On the surface, with the second one somewhere else.
    [[nodiscard]] static std::vector<Vec3> picksOn(const CurveDesigner& designer, double by) {
        const Surface& surface = surfaceOf(designer);
        const TriangleTree tree(surface.vertices(), surface.faces());
        std::vector<Vec3> picks = {
            {1.0, 0.0, 0.0}, {0.5, 0.7, 0.3}, {-0.4, 0.8, 0.5}, {-1.0, 0.0, 0.2}
        };
        picks[1] += by * Vec3(0.3, 0.1, -0.2);
        for (Vec3& pick : picks) {
            pick = tree.closestPoint(pick).position;
        }
        return picks;
    }

    [[nodiscard]] static TriangleMesh bumpy() { return withNoise(icosphere(4), 0.002, 5); }
};

double bendingOf(const Curve& curve) {
    return curve.report.iterations.back().terms.internal;
}

TEST_P(DraggedPick, PassesThePicksWithFewSteps) {
    const CurveDesigner designer = designerOn(bumpy());
    const std::vector<Vec3> picks = picksOn(designer, 0.0);
    Curve curve = goodCurve(designer, picks);
    const int stepsFromScratch = curve.report.newtonIterations;
    ASSERT_TRUE(curve.report.isSampled);
    for (int step = 1; step <= 5; ++step) {
        const std::vector<Vec3> others = picksOn(designer, 0.05 * step);
        const Curve next = designer.design(others, {}, {}, {.start = &curve});
        const Curve fresh = goodCurve(designer, others);
        expectGoodCurve(designer, next, others);
        EXPECT_LE(next.report.newtonIterations, stepsFromScratch) << step;
        EXPECT_LT(bendingOf(next), 1.1 * bendingOf(fresh)) << step;
        curve = next;
    }
}

TEST_P(DraggedPick, StaysWhereNothingMoved) {
    const CurveDesigner designer = designerOn(bumpy());
    const std::vector<Vec3> picks = picksOn(designer, 0.0);
    const Curve curve = goodCurve(designer, picks);
    const Curve again = designer.design(picks, {}, {}, {.start = &curve});
    EXPECT_TRUE(again.report.usable);
    EXPECT_LT(bendingOf(again), 1.02 * bendingOf(curve));
}

TEST_P(DraggedPick, StartsFromScratchWhereTheCurveDoesNotFit) {
    const CurveDesigner designer = designerOn(icosphere(4));
    const std::vector<Vec3> picks = picksOn(designer, 0.0);
    const Curve curve = goodCurve(designer, picks);
    SolverOptions quartic;
    quartic.degree = 4;
    const Curve fresh = designer.design(picks, quartic);
    const Curve started = designer.design(picks, quartic, {}, {.start = &curve});
    EXPECT_EQ(fresh.polyline.points, started.polyline.points);
    const std::vector<Vec3> fewer(picks.begin(), picks.end() - 1);
    EXPECT_EQ(
        designer.design(fewer).polyline.points,
        designer.design(fewer, {}, {}, {.start = &curve}).polyline.points
    );
}

TEST_P(DraggedPick, ClosedCurvesToo) {
    const CurveDesigner designer = designerOn(bumpy());
    const std::vector<Vec3> picks = picksOn(designer, 0.0);
    const SolverOptions closed = closedOptions();
    const Curve curve = goodCurve(designer, picks, closed);
    const std::vector<Vec3> others = picksOn(designer, 0.1);
    const Curve next = designer.design(others, closed, {}, {.start = &curve});
    expectGoodCurve(designer, next, others);
    EXPECT_TRUE(next.polyline.closed);
    EXPECT_LE(next.report.newtonIterations, curve.report.newtonIterations);
}

INSTANTIATE_TEST_SUITE_P(All, DraggedPick, kEitherShell, nameOfShell);

}  // namespace
}  // namespace bspline_curve
