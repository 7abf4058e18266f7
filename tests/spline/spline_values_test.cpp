// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/spline.h"
#include "spline/spline_space.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace bspline_curve::design_tests {

namespace {

/// A spline through no particular points, with the space and the controls that it comes from.
class ASplineOf : public testing::TestWithParam<std::pair<int, bool>> {
protected:
    ASplineOf()
        : space_(degree(), closed(), {0.0, 0.11, 0.3, 0.42, 0.5, 0.77, 0.9, 1.0}),
          controls_(space_.controlCount(), 3) {
        spline_.degree = degree();
        spline_.closed = closed();
        spline_.knots = space_.knotVector();
        const int count = space_.controlCount();
        for (int i = 0; i < count; ++i) {
            controls_.row(i) << std::sin(3.1 * i), std::cos(1.7 * i), std::sin(0.4 * i * i);
        }
        for (int i = 0; i < count + (closed() ? degree() : 0); ++i) {
            spline_.controlPoints.emplace_back(controls_.row(i % count).transpose());
        }
    }

    static int degree() { return GetParam().first; }

    static bool closed() { return GetParam().second; }

    [[nodiscard]] Vec3 at(double t) const { return space_.evaluate(controls_, t); }

    SplineSpace space_;
    ControlPoints controls_;
    SplineData spline_;
};

TEST_P(ASplineOf, HasThePositionsOfItsSpace) {
    for (const double t : {0.0, 0.05, 0.3, 0.43, 0.76, 0.9999, 1.0}) {
        EXPECT_LT((positionOf(spline_, t) - at(t)).norm(), 1e-13) << t;
    }
}

TEST_P(ASplineOf, HasDerivativesThatDifferencesHave) {
    constexpr double kStep = 1e-5;
    for (const double t : {0.05, 0.2, 0.45, 0.6, 0.95}) {
        const Vec3 first = (at(t + kStep) - at(t - kStep)) / (2.0 * kStep);
        EXPECT_LT((derivativeOf(spline_, t) - first).norm(), 1e-6 * (1.0 + first.norm())) << t;
        for (int order = 2; order <= degree(); ++order) {
            const Vec3 higher = (derivativeOf(spline_, t + kStep, order - 1) -
                                 derivativeOf(spline_, t - kStep, order - 1)) /
                                (2.0 * kStep);
            const Vec3 found = derivativeOf(spline_, t, order);
            EXPECT_LT((found - higher).norm(), 1e-5 * (1.0 + higher.norm())) << t << " " << order;
        }
        EXPECT_EQ(derivativeOf(spline_, t, degree() + 1), Vec3(Vec3::Zero()));
    }
}

TEST_P(ASplineOf, IsItsBezierPieces) {
    const std::vector<BezierPiece> pieces = bezierPieces(spline_);
    ASSERT_EQ(pieces.size(), 7U);
    EXPECT_EQ(pieces.front().from, 0.0);
    EXPECT_EQ(pieces.back().to, 1.0);
    for (const BezierPiece& piece : pieces) {
        for (const double share : {0.0, 0.3, 1.0}) {
            std::vector<Vec3> points = piece.controlPoints;
            ASSERT_EQ(points.size(), static_cast<std::size_t>(degree()) + 1);
            for (std::size_t left = points.size() - 1; left > 0; --left) {  // de Casteljau
                for (std::size_t i = 0; i < left; ++i) {
                    points[i] = (1.0 - share) * points[i] + share * points[i + 1];
                }
            }
            const double t = (1.0 - share) * piece.from + share * piece.to;
            EXPECT_LT((points[0] - at(t)).norm(), 1e-13) << t;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    Degrees,
    ASplineOf,
    testing::Values(
        std::pair(1, false),
        std::pair(2, false),
        std::pair(3, false),
        std::pair(4, false),
        std::pair(2, true),
        std::pair(3, true),
        std::pair(4, true)
    ),
    [](const auto& each) {
        return (each.param.second ? "Closed" : "Open") + std::to_string(each.param.first);
    }
);

TEST(CurvatureOf, ACircleIsTowardsItsCentre) {
    // Control points on a circle: the spline is one of nearly that radius.
    constexpr int kCount = 60;
    constexpr double kRadius = 4.0;
    SplineData spline;
    spline.closed = true;
    for (int i = 0; i < kCount + 3; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / kCount;
        spline.controlPoints.emplace_back(
            kRadius * std::cos(angle), kRadius * std::sin(angle), 1.0
        );
    }
    for (int i = -3; i <= kCount + 3; ++i) {
        spline.knots.push_back(static_cast<double>(i) / kCount);
    }
    for (const double t : {0.0, 0.123, 0.5, 1.0}) {
        const Vec3 inwards = Vec3(0.0, 0.0, 1.0) - positionOf(spline, t);
        EXPECT_LT(
            (curvatureOf(spline, t) - inwards / inwards.squaredNorm()).norm(), 1e-3 / kRadius
        );
    }
}

TEST(CurvatureOf, ACornerIsThatBehindIt) {
    SplineData spline;
    spline.degree = 2;
    spline.knots = {0, 0, 0, 0.5, 0.5, 1, 1, 1};
    spline.controlPoints = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 2, 0}};
    EXPECT_EQ(curvatureOf(spline, 0.4), Vec3(Vec3::Zero()));
    EXPECT_GT(curvatureOf(spline, 0.5).norm(), 0.1);
    EXPECT_EQ(derivativeOf(spline, 0.5).x(), 0.0);
}

}  // namespace

}  // namespace bspline_curve::design_tests
