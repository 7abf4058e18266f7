// SPDX-License-Identifier: GPL-3.0-or-later
// Where a curve lies once its picks have been dragged, before it is relaxed.
#include "design/warm_start.h"

#include "curve_checks.h"

#include <algorithm>

namespace bspline_curve {
namespace {

using namespace test_support;

class WarmStarts : public testing::TestWithParam<bool> {
protected:
    [[nodiscard]] Curve curve() const {
        // With many knots.
        const SolverOptions options{.closed = GetParam(), .fairness = Fairness::Parametric};
        return goodCurve(designer_, ground_.positions(picks_), options);
    }

    // The picks with one of them somewhere else.
    [[nodiscard]] std::vector<SurfacePoint> moved(std::size_t pick, const Vec3& by) const {
        std::vector<SurfacePoint> picks = picks_;
        picks[pick] = ground_.nearest(Vec3(ground_.surface.position(picks[pick]) + by));
        return picks;
    }

    [[nodiscard]] WarmStart dragged(
        const Curve& curve, const std::vector<SurfacePoint>& picks
    ) const {
        return dragCurve(curve, ground_.extended, picks).value();
    }

    // Where the initial path is at a pick.
    [[nodiscard]] static Vec3 positionAt(const WarmStart& curve, double parameter) {
        const auto& points = curve.path.path.points;
        return std::ranges::min_element(
                   points, {}, [&](const InitialPath::Point& point) {
                       return std::abs(point.parameter - parameter);
                   }
        )->position;
    }

    // Of the pieces between picks.
    [[nodiscard]] static std::vector<double> lengthsOf(const WarmStart& curve) {
        std::vector<double> result(curve.path.picks.size(), 0.0);
        const auto& points = curve.path.path.points;
        std::size_t piece = 0;
        for (std::size_t i = 1; i < points.size(); ++i) {
            const double middle = 0.5 * (points[i - 1].parameter + points[i].parameter);
            while (piece + 1 < result.size() && curve.path.picks[piece + 1].parameter <= middle) {
                ++piece;
            }
            result[piece] += (points[i].position - points[i - 1].position).norm();
        }
        return result;
    }

    [[nodiscard]] static std::vector<double> widthsOf(const WarmStart& curve) {
        std::vector<double> result;
        for (std::size_t i = 1; i < curve.path.picks.size(); ++i) {
            result.push_back(curve.path.picks[i].parameter - curve.path.picks[i - 1].parameter);
        }
        return result;
    }

    TestSurface ground_{withNoise(icosphere(4), 0.002, 5)};
    CurveDesigner designer_{withNoise(icosphere(4), 0.002, 5)};
    std::vector<SurfacePoint> picks_ = ground_.nearest(
        std::vector<Vec3>{{1.0, 0.0, 0.0}, {0.5, 0.7, 0.3}, {-0.4, 0.8, 0.5}, {-1.0, 0.0, 0.2}}
    );
};

TEST_P(WarmStarts, AreTheSameWhereNothingMoved) {
    const Curve before = curve();
    const WarmStart after = dragged(before, picks_);
    const SurfacePolyline& line = before.polyline;
    for (std::size_t i = 0; i < picks_.size(); ++i) {
        EXPECT_NEAR(after.path.picks[i].parameter, before.spline.pickParameters[i], 1e-12);
    }
    const auto degree = static_cast<std::size_t>(before.spline.degree);
    const std::vector<double>& breaks = after.spline.space.breaks();
    ASSERT_EQ(breaks.size() + 2 * degree, before.spline.knots.size());
    for (std::size_t i = 0; i < breaks.size(); ++i) {
        EXPECT_NEAR(breaks[i], before.spline.knots[i + degree], 1e-12);
    }
    for (int c = 0; c < after.spline.space.controlCount(); ++c) {
        const Vec3 there = ground_.extended.frame.toUnit(before.spline.controlPoints[c]);
        EXPECT_LT((after.spline.controls.row(c).transpose() - there).norm(), 1e-12);
    }
    for (std::size_t i = 0; i < line.points.size(); ++i) {
        EXPECT_LT(
            (positionAt(after, line.parameters[i]) -
             ground_.extended.position(line.surfacePoints[i]))
                .norm(),
            1e-9
        );
    }
}

TEST_P(WarmStarts, PassThePicksThatMoved) {
    const Curve before = curve();
    for (std::size_t pick = 0; pick < picks_.size(); ++pick) {
        SCOPED_TRACE("pick " + std::to_string(pick));
        const std::vector<SurfacePoint> picks = moved(pick, {0.1, -0.05, 0.1});
        const WarmStart after = dragged(before, picks);
        const auto& [space, controls] = after.spline;
        for (const PickConstraint& constraint : after.path.picks) {
            const double t = constraint.parameter;
            EXPECT_LT((positionAt(after, t) - constraint.position).norm(), 1e-12);
            // A kink of the displacements is rounded off.
            EXPECT_LT((space.evaluate(controls, t) - constraint.position).norm(), 0.01);
        }
        const std::vector<double>& breaks = space.breaks();
        EXPECT_TRUE(std::ranges::is_sorted(breaks));
        EXPECT_EQ(std::ranges::adjacent_find(breaks), breaks.end());
        EXPECT_EQ(breaks.front(), 0.0);
        EXPECT_EQ(breaks.back(), 1.0);
        const std::vector<InitialPath::Point>& points = after.path.path.points;
        EXPECT_TRUE(std::ranges::is_sorted(points, {}, &InitialPath::Point::parameter));
        EXPECT_EQ(points.back().parameter, 1.0);
    }
}

// What lies between picks that stay does not move.
TEST_P(WarmStarts, StayWhereNoPickNearbyMoved) {
    const Curve before = curve();
    const WarmStart after = dragged(before, moved(0, {0.0, -0.1, 0.1}));
    const SplineSpace& space = after.spline.space;
    const double begin = before.spline.pickParameters[1];
    const double end = before.spline.pickParameters[3];
    int still = 0;
    for (int c = 0; c < space.controlCount(); ++c) {
        const Vec3 there = ground_.extended.frame.toUnit(before.spline.controlPoints[c]);
        const double moved = (after.spline.controls.row(c).transpose() - there).norm();
        const double first = before.spline.knots[c + 1];
        const double last = before.spline.knots[c + space.degree()];
        if (first > begin && last < end) {
            EXPECT_LT(moved, 1e-12);
            ++still;
        } else if (last < begin && first > 0.0) {
            EXPECT_GT(moved, 1e-3 * (begin - last));
        }
    }
    EXPECT_GT(still, 2);
}

// A piece that became longer than another has as much more of the parameters.
TEST_P(WarmStarts, HaveParametersByTheLengthsOfTheirPieces) {
    const Curve before = curve();
    const WarmStart after = dragged(before, moved(1, {0.2, -0.1, 0.0}));
    const WarmStart still = dragged(before, picks_);
    const auto growth = [&](std::size_t i) { return lengthsOf(after)[i] / lengthsOf(still)[i]; };
    const auto speedUp = [&](std::size_t i) {
        return growth(i) * widthsOf(still)[i] / widthsOf(after)[i];
    };
    EXPECT_GT(std::abs(growth(0) - 1.0), 0.1);
    EXPECT_NEAR(speedUp(0) / speedUp(1), 1.0, 1e-9);
    EXPECT_NEAR(speedUp(1) / speedUp(2), 1.0, 1e-9);
}

TEST_P(WarmStarts, AreNoneWhereAPieceAllButVanishes) {
    EXPECT_FALSE(dragCurve(curve(), ground_.extended, moved(1, {0.4, -0.65, -0.3})).has_value());
}

INSTANTIATE_TEST_SUITE_P(
    All, WarmStarts, testing::Bool(), [](const testing::TestParamInfo<bool>& instance) {
        return instance.param ? "Closed" : "Open";
    }
);

}  // namespace
}  // namespace bspline_curve
