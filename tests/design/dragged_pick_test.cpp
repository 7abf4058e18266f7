// SPDX-License-Identifier: GPL-3.0-or-later
// Curves that start from one through picks nearby, as while a pick is dragged.
#include "curve_checks.h"

namespace bspline_curve {
namespace {

using namespace test_support;

class DraggedPick : public EitherShell {
protected:
    // On the surface, with the second one somewhere else.
    [[nodiscard]] std::vector<Vec3> picksDragged(double by) const {
        return onSurface(
            mesh_,
            {{1.0, 0.0, 0.0},
             Vec3(0.5, 0.7, 0.3) + by * Vec3(0.3, 0.1, -0.2),
             {-0.4, 0.8, 0.5},
             {-1.0, 0.0, 0.2}}
        );
    }

    TriangleMesh mesh_ = withNoise(icosphere(4), 0.002, 5);
    CurveDesigner designer_ = designerOn(mesh_);
    std::vector<Vec3> picks_ = picksDragged(0.0);
};

double bendingOf(const Curve& curve) {
    return curve.report.iterations.back().terms.internal;
}

TEST_P(DraggedPick, PassesThePicksWithFewSteps) {
    Curve curve = goodCurve(designer_, picks_);
    const int stepsFromScratch = curve.report.newtonIterations;
    ASSERT_TRUE(curve.report.isSampled);
    for (int step = 1; step <= 5; ++step) {
        const std::vector<Vec3> others = picksDragged(0.05 * step);
        const Curve next = goodCurve(designer_, others, {}, {.start = &curve});
        const Curve fresh = goodCurve(designer_, others);
        EXPECT_LE(next.report.newtonIterations, stepsFromScratch + 1) << step;
        EXPECT_LT(bendingOf(next), 1.1 * bendingOf(fresh)) << step;
        curve = next;
    }
}

TEST_P(DraggedPick, StaysWhereNothingMoved) {
    const Curve curve = goodCurve(designer_, picks_);
    const Curve again = designer_.design(picks_, {}, {}, {.start = &curve});
    EXPECT_TRUE(again.report.usable);
    EXPECT_LT(bendingOf(again), 1.02 * bendingOf(curve));
}

TEST_P(DraggedPick, StartsFromScratchWhereTheCurveDoesNotFit) {
    const Curve curve = goodCurve(designer_, picks_);
    const auto expectFresh = [&](const std::vector<Vec3>& picks, const SolverOptions& options) {
        const Curve fresh = designer_.design(picks, options);
        const Curve started = designer_.design(picks, options, {}, {.start = &curve});
        EXPECT_EQ(fresh.polyline.points, started.polyline.points);
    };
    expectFresh(picks_, {.degree = 4});
    expectFresh({picks_.begin(), picks_.end() - 1}, {});
}

TEST_P(DraggedPick, ClosedCurvesToo) {
    const SolverOptions closed{.closed = true};
    const Curve curve = goodCurve(designer_, picks_, closed);
    const Curve next = goodCurve(designer_, picksDragged(0.1), closed, {.start = &curve});
    EXPECT_TRUE(next.polyline.closed);
    EXPECT_LE(next.report.newtonIterations, curve.report.newtonIterations + 1);
}

INSTANTIATE_TEST_SUITE_P(All, DraggedPick, kEitherShell, nameOfShell);

}  // namespace
}  // namespace bspline_curve
