// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/knot_removal.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

namespace bspline_curve {
namespace {

/// A surface by two angles or coordinates.
using Place = std::function<Vec3(double, double)>;

Vec3 onPlane(double u, double v) {
    return {0.3 * u, 0.3 * v, 0.0};
}

Vec3 onSphere(double u, double v) {
    return 0.5 * Vec3(std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v));
}

Vec3 onBumpyTorus(double u, double v) {
    const double tube = 0.15 + 0.02 * std::sin(5.0 * u) * std::cos(3.0 * v);
    const double radius = 0.35 + tube * std::cos(v);
    return {radius * std::cos(u), radius * std::sin(u), tube * std::sin(v)};
}

Vec3 normalAt(const Place& place, double u, double v) {
    constexpr double kStep = 1e-5;
    const Vec3 along = place(u + kStep, v) - place(u - kStep, v);
    return along.cross(place(u, v + kStep) - place(u, v - kStep)).normalized();
}

/// A spline of few uneven spans with its control points on a surface, and the normals there.
struct Planted {
    SplineCurve curve;
    std::vector<PickConstraint> picks;
    std::function<Vec3(double)> normal;
};

Planted plant(const Place& place, int degree, bool closed, std::mt19937& random) {
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    constexpr int kSpans = 9;
    std::vector<double> breaks{0.0};
    for (int i = 1; i <= kSpans; ++i) {
        breaks.push_back(breaks.back() + 0.6 + 0.8 * uniform(random));
    }
    const double length = breaks.back();
    for (double& t : breaks) {
        t /= length;
    }
    breaks.back() = 1.0;
    SplineSpace space(degree, closed, breaks);
    ControlPoints controls(space.controlCount(), 3);
    const auto u = [=](double t) { return closed ? 2.0 * std::numbers::pi * t : 3.0 * t; };
    std::vector<double> v(space.controlCount());
    for (int i = 0; i < space.controlCount(); ++i) {
        v[i] = 0.8 * (uniform(random) - 0.5);
        controls.row(i) = place(u(static_cast<double>(i) / space.controlCount()), v[i]).transpose();
    }
    const double middle = 0.0;
    Planted planted{{space, controls}, {}, [=](double t) { return normalAt(place, u(t), middle); }};
    for (const double t : {0.0, 0.37, closed ? 0.71 : 1.0}) {
        planted.picks.push_back({{}, space.evaluate(controls, t), t});
    }
    return planted;
}

std::vector<SeenSample> samplesOf(const Planted& planted, const SplineSpace& space) {
    std::vector<SeenSample> samples;
    const SplineCurve& curve = planted.curve;
    for (int span = 0; span < space.spanCount(); ++span) {
        for (const double tau : {0.1, 0.4, 0.6, 0.9}) {
            const double t = space.breaks()[span] + tau * space.spanLength(span);
            const int in = curve.space.spanAt(t);
            const double length = curve.space.spanLength(in);
            const PolynomialCurve p = curve.space.polynomial(curve.controls, in);
            const double x = (t - curve.space.breaks()[in]) / length;
            Vec3 second = Vec3::Zero();
            for (int m = p.degree; m >= 2; --m) {
                second = second * x + m * (m - 1) * p.coefficients[m];
            }
            samples.push_back(
                {t,
                 0.25 * space.spanLength(span),
                 p.at(x),
                 second / (length * length),
                 planted.normal(t),
                 0.0}
            );
        }
    }
    return samples;
}

/// The same curve with more knots at random places.
SplineCurve withMoreKnots(const SplineCurve& curve, int more, std::mt19937& random) {
    std::vector<double> breaks = curve.space.breaks();
    std::uniform_real_distribution<double> uniform(0.2, 0.8);
    for (int span = 0; span < curve.space.spanCount(); ++span) {
        for (int i = 0; i < more; ++i) {
            breaks.push_back(
                curve.space.breaks()[span] +
                (i + uniform(random)) / more * curve.space.spanLength(span)
            );
        }
    }
    std::ranges::sort(breaks);
    SplineSpace space(curve.space.degree(), curve.space.closed(), std::move(breaks));
    ControlPoints controls = refine(curve.space, curve.controls, space);
    return {std::move(space), std::move(controls)};
}

constexpr RemovalLimits kTight{1e-6, 1e-6, 1e-6, 1.0};

TEST(KnotRemoval, FindsPlantedKnotsAgain) {
    std::mt19937 random(7);
    int planted = 0;
    int found = 0;
    int left = 0;
    for (const Place& place : {Place(onPlane), Place(onSphere), Place(onBumpyTorus)}) {
        for (const int degree : {2, 3, 4}) {
            for (const bool closed : {false, true}) {
                const Planted few = plant(place, degree, closed, random);
                const SplineCurve many = withMoreKnots(few.curve, 4, random);
                KnotRemoval removal(many, few.picks, samplesOf(few, many.space), kTight);
                const SplineCurve again = removal.run();
                const std::vector<double>& breaks = again.space.breaks();
                for (const double t : few.curve.space.breaks()) {
                    found += std::ranges::binary_search(breaks, t) ? 1 : 0;
                }
                planted += static_cast<int>(few.curve.space.breaks().size());
                left += static_cast<int>(breaks.size());
            }
        }
    }
    EXPECT_GE(found, 0.95 * planted);
    EXPECT_LE(left, 1.05 * planted);
}

TEST(KnotRemoval, KeepsPicksAndLimits) {
    std::mt19937 random(11);
    const Planted few = plant(onBumpyTorus, 3, true, random);
    const SplineCurve many = withMoreKnots(few.curve, 3, random);
    constexpr double kHeight = 2e-3;
    std::vector<SeenSample> samples = samplesOf(few, many.space);
    KnotRemoval removal(many, few.picks, samples, {kHeight, 0.02, 0.5, 1.0});
    const SplineCurve fewer = removal.run();
    EXPECT_LT(fewer.space.spanCount(), many.space.spanCount());
    for (const PickConstraint& pick : few.picks) {
        const Vec3 passed = fewer.space.evaluate(fewer.controls, pick.parameter);
        EXPECT_LT((passed - pick.position).norm(), 1e-12);
    }
    for (const SeenSample& sample : samples) {
        const Vec3 moved = fewer.space.evaluate(fewer.controls, sample.parameter) - sample.position;
        EXPECT_LE(std::abs(sample.normal.dot(moved)), kHeight * (1.0 + 1e-9));
    }
}

TEST(KnotRemoval, PutsKnotsBackWhereAskedTo) {
    std::mt19937 random(5);
    const Planted few = plant(onSphere, 3, false, random);
    const SplineCurve many = withMoreKnots(few.curve, 4, random);
    KnotRemoval removal(many, few.picks, samplesOf(few, many.space), kTight);
    const SplineCurve fewer = removal.run();
    std::vector<char> marked(fewer.space.spanCount(), 0);
    marked[2] = 1;
    const SplineCurve back = removal.withKnotsBack(marked);
    const double begin = fewer.space.breaks()[2];
    const double end = fewer.space.breaks()[3];
    const auto isInside = [&](double t) { return t > begin && t < end; };
    const auto inside = std::ranges::count_if(many.space.breaks(), isInside);
    EXPECT_GT(inside, 0);
    EXPECT_EQ(std::ranges::count_if(back.space.breaks(), isInside), inside);
    EXPECT_EQ(back.space.spanCount(), fewer.space.spanCount() + inside);
}

TEST(KnotRemoval, LeavesASplineThatNeedsAllItsKnots) {
    std::mt19937 random(3);
    const Planted few = plant(onPlane, 3, false, random);
    KnotRemoval removal(few.curve, few.picks, samplesOf(few, few.curve.space), kTight);
    const SplineCurve same = removal.run();
    EXPECT_EQ(same.space.breaks(), few.curve.space.breaks());
    EXPECT_LT((same.controls - few.curve.controls).norm(), 1e-12);
}

}  // namespace
}  // namespace bspline_curve
