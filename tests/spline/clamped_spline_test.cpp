// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/spline.h"
#include "spline/spline_space.h"

#include <gtest/gtest.h>

#include <random>

namespace bspline_curve::design_tests {

namespace {

/// A random spline as SplineData keeps it, and the space and controls that it comes from.
struct RandomSpline {
    SplineSpace space;
    ControlPoints controls;
    SplineData data;
};

RandomSpline randomSpline(int degree, bool closed, std::mt19937& random) {
    std::uniform_real_distribution<double> uniform(0.1, 1.0);
    std::vector<double> breaks{0.0};
    for (int i = 0; i < degree + 3; ++i) {
        breaks.push_back(breaks.back() + uniform(random));
    }
    for (double& t : breaks) {
        t /= breaks.back();
    }
    RandomSpline result{.space = SplineSpace(degree, closed, breaks), .controls = {}, .data = {}};
    const int count = result.space.controlCount();
    result.controls.resize(count, 3);
    for (int i = 0; i < count; ++i) {
        result.controls.row(i) << uniform(random), uniform(random), uniform(random);
    }
    result.data.degree = degree;
    result.data.closed = closed;
    result.data.knots = result.space.knotVector();
    for (int i = 0; i < count + (closed ? degree : 0); ++i) {
        result.data.controlPoints.emplace_back(result.controls.row(i % count));
    }
    return result;
}

/// By the recursive definition of the basis functions, term by term.
double basis(const std::vector<double>& knots, std::size_t i, int degree, double t) {
    if (degree == 0) {
        return knots[i] <= t && t < knots[i + 1] ? 1.0 : 0.0;
    }
    const auto term = [&](std::size_t from, double numerator, double denominator) {
        return denominator > 0.0 ? numerator / denominator * basis(knots, from, degree - 1, t)
                                 : 0.0;
    };
    const auto p = static_cast<std::size_t>(degree);
    return term(i, t - knots[i], knots[i + p] - knots[i]) +
           term(i + 1, knots[i + p + 1] - t, knots[i + p + 1] - knots[i + 1]);
}

Vec3 evaluate(const SplineData& spline, double t) {
    Vec3 point = Vec3::Zero();
    for (std::size_t i = 0; i < spline.controlPoints.size(); ++i) {
        point += basis(spline.knots, i, spline.degree, t) * spline.controlPoints[i];
    }
    return point;
}

}  // namespace

TEST(ClampedSpline, IsTheSameCurve) {
    constexpr unsigned kSeed = 7;
    std::mt19937 random(kSeed);
    for (const int degree : {2, 3, 4}) {
        for (const bool closed : {false, true}) {
            SCOPED_TRACE(testing::Message() << "degree " << degree << ", closed " << closed);
            const RandomSpline original = randomSpline(degree, closed, random);
            const SplineData result = clamped(original.data);
            ASSERT_EQ(result.knots.size(), original.data.knots.size());
            ASSERT_EQ(result.controlPoints.size(), original.data.controlPoints.size());
            for (std::size_t k = 0; k <= static_cast<std::size_t>(degree); ++k) {
                EXPECT_EQ(result.knots[k], 0.0);
                EXPECT_EQ(result.knots[result.knots.size() - 1 - k], 1.0);
            }
            for (int i = 0; i < 100; ++i) {
                const double t = i / 100.0;
                const Vec3 expected = original.space.evaluate(original.controls, t);
                EXPECT_LT((evaluate(result, t) - expected).norm(), 1e-14) << t;
            }
        }
    }
}

TEST(ClampedSpline, OfAClosedOneBeginsAndEndsInOnePoint) {
    std::mt19937 random(8);
    const RandomSpline original = randomSpline(3, true, random);
    const SplineData result = clamped(original.data);
    EXPECT_LT((result.controlPoints.front() - result.controlPoints.back()).norm(), 1e-15);
    EXPECT_LT(
        (result.controlPoints.front() - original.space.evaluate(original.controls, 0.0)).norm(),
        1e-15
    );
}

TEST(ClampedSpline, LeavesAnOpenOneAsItIs) {
    std::mt19937 random(9);
    const RandomSpline original = randomSpline(4, false, random);
    const SplineData result = clamped(original.data);
    EXPECT_EQ(result.knots, original.data.knots);
    EXPECT_EQ(result.controlPoints, original.data.controlPoints);
}

}  // namespace bspline_curve::design_tests
