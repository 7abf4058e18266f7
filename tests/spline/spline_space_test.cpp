// SPDX-License-Identifier: GPL-3.0-or-later
#include "spline/spline_space.h"

#include "basis_derivative.h"
#include "support/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <tuple>
#include <vector>

namespace bspline_curve {
namespace {

using test_support::Random;

// The recursion of Cox and de Boor, word for word, with 0 / 0 = 0. Right-continuous.
double coxDeBoor(const std::vector<double>& knots, int i, int degree, double t) {
    if (degree == 0) {
        return knots[i] <= t && t < knots[i + 1] ? 1.0 : 0.0;
    }
    double value = 0.0;
    const double left = knots[i + degree] - knots[i];
    if (left > 0.0) {
        value += (t - knots[i]) / left * coxDeBoor(knots, i, degree - 1, t);
    }
    const double right = knots[i + degree + 1] - knots[i + 1];
    if (right > 0.0) {
        value += (knots[i + degree + 1] - t) / right * coxDeBoor(knots, i + 1, degree - 1, t);
    }
    return value;
}

std::vector<double> randomBreaks(Random& random, int spans, double shortest) {
    std::vector<double> breaks{0.0};
    for (int i = 0; i < spans; ++i) {
        breaks.push_back(breaks.back() + random.uniform(shortest, 1.0));
    }
    const double end = breaks.back();
    for (double& value : breaks) {
        value /= end;
    }
    return breaks;
}

ControlPoints randomControls(Random& random, const SplineSpace& space) {
    ControlPoints controls(space.controlCount(), 3);
    for (int i = 0; i < space.controlCount(); ++i) {
        controls.row(i) = random.point(-1.0, 1.0).transpose();
    }
    return controls;
}

// Derivative of a spline by t at the start or the end of a span.
Vec3 derivative(
    const SplineSpace& space, const ControlPoints& controls, int span, double tau, int order
) {
    const SplineSpace::BasisValues values = test_support::basisDerivative(space, span, tau, order);
    Vec3 sum = Vec3::Zero();
    for (int j = 0; j < space.basisCount(); ++j) {
        sum += values[j] * controls.row(space.control(span, j)).transpose();
    }
    return sum;
}

class SplineSpaces : public testing::TestWithParam<std::tuple<int, bool>> {
protected:
    static constexpr std::uint64_t kSeed = 20;

    [[nodiscard]] static int degree() { return std::get<0>(GetParam()); }

    [[nodiscard]] static bool closed() { return std::get<1>(GetParam()); }

    Random random_{kSeed};
    SplineSpace space_{degree(), closed(), randomBreaks(random_, 9, 0.1)};
    ControlPoints controls_ = randomControls(random_, space_);
    testing::ScopedTrace trace_{__FILE__, __LINE__, "seed " + std::to_string(kSeed)};
};

TEST_P(SplineSpaces, BasisFunctionsSumToOneAndAreNotNegative) {
    for (int span = 0; span < space_.spanCount(); ++span) {
        for (const double tau : {0.0, 0.1, 0.37, 0.5, 0.93, 1.0}) {
            const SplineSpace::BasisValues values = space_.basisAt(span, tau);
            double sum = 0.0;
            for (int j = 0; j < space_.basisCount(); ++j) {
                sum += values[j];
                EXPECT_GE(values[j], -1e-15);
            }
            EXPECT_NEAR(sum, 1.0, 1e-14) << "span " << span << ", tau " << tau;
        }
    }
}

TEST_P(SplineSpaces, AgreeWithTheRecursionOnTheFullKnotVector) {
    const std::vector<double> knots = space_.knotVector();
    const int functions = static_cast<int>(knots.size()) - degree() - 1;
    ASSERT_EQ(functions, space_.controlCount() + (closed() ? degree() : 0));
    for (int i = 0; i < 1000; ++i) {
        const double t = random_.uniform(0.0, 1.0);
        Vec3 expected = Vec3::Zero();
        for (int c = 0; c < functions; ++c) {
            expected += coxDeBoor(knots, c, degree(), t) *
                        controls_.row(c % space_.controlCount()).transpose();
        }
        EXPECT_LT((space_.evaluate(controls_, t) - expected).norm(), 1e-13) << "t = " << t;
    }
}

TEST_P(SplineSpaces, KnotVectorsAreClampedOrPeriodic) {
    const std::vector<double> knots = space_.knotVector();
    const int n = space_.spanCount();
    ASSERT_EQ(static_cast<int>(knots.size()), n + 1 + 2 * degree());
    for (int i = 0; i <= n; ++i) {
        EXPECT_EQ(knots[i + degree()], space_.breaks()[i]);
    }
    for (int i = 0; i <= 2 * degree(); ++i) {
        if (closed()) {
            EXPECT_NEAR(knots[i + n], knots[i] + 1.0, 1e-15) << "knot " << i;
        } else if (i <= degree()) {
            EXPECT_EQ(knots[i], 0.0);
            EXPECT_EQ(knots[knots.size() - 1 - i], 1.0);
        }
    }
}

TEST_P(SplineSpaces, DerivativesAgreeWithDifferences) {
    constexpr double kStep = 1e-5;
    for (int span = 0; span < space_.spanCount(); ++span) {
        const double h = kStep * space_.spanLength(span);
        for (const double tau : {0.2, 0.5, 0.8}) {
            for (int order = 1; order <= degree(); ++order) {
                const Vec3 up = derivative(space_, controls_, span, tau + kStep, order - 1);
                const Vec3 down = derivative(space_, controls_, span, tau - kStep, order - 1);
                const Vec3 exact = derivative(space_, controls_, span, tau, order);
                const double scale = 1.0 + exact.norm() + up.norm() / space_.spanLength(span);
                EXPECT_LT(((up - down) / (2.0 * h) - exact).norm(), 1e-8 * scale)
                    << "span " << span << ", tau " << tau << ", order " << order;
            }
        }
    }
}

TEST_P(SplineSpaces, AreSmoothAtTheirKnots) {
    for (int span = closed() ? 0 : 1; span < space_.spanCount(); ++span) {
        // Closed splines also from t = 1 to t = 0.
        const int before = span == 0 ? space_.spanCount() - 1 : span - 1;
        for (int order = 0; order < degree(); ++order) {
            const Vec3 left = derivative(space_, controls_, before, 1.0, order);
            const Vec3 right = derivative(space_, controls_, span, 0.0, order);
            EXPECT_LT((left - right).norm(), 1e-12 * (1.0 + left.norm()))
                << "knot " << span << ", order " << order;
        }
    }
}

TEST_P(SplineSpaces, PolynomialsOfSpansAreTheSpline) {
    for (int span = 0; span < space_.spanCount(); ++span) {
        const PolynomialCurve polynomial = space_.polynomial(controls_, span);
        for (const double tau : {0.0, 0.3, 0.9}) {
            const double t = space_.breaks()[span] + tau * space_.spanLength(span);
            EXPECT_LT((polynomial.at(tau) - space_.evaluate(controls_, t)).norm(), 1e-13);
            EXPECT_LT(
                (polynomial.derivativeAt(tau) / space_.spanLength(span) -
                 derivative(space_, controls_, span, tau, 1))
                    .norm(),
                1e-11
            );
        }
    }
}

TEST_P(SplineSpaces, RefiningLeavesTheCurveUnchanged) {
    for (int trial = 0; trial < 20; ++trial) {
        std::vector<double> finer{0.0};
        for (int span = 0; span < space_.spanCount(); ++span) {
            const int inserted = random_.integer(0, 3);
            for (int i = 1; i <= inserted; ++i) {
                finer.push_back(
                    space_.breaks()[span] + space_.spanLength(span) * i / (inserted + 1.0)
                );
            }
            finer.push_back(space_.breaks()[span + 1]);
        }
        const SplineSpace fine(degree(), closed(), finer);
        const ControlPoints controls = refine(space_, controls_, fine);
        double largest = 0.0;
        for (int i = 0; i <= 1000; ++i) {
            const double t = i / 1000.0;
            largest = std::max(
                largest, (fine.evaluate(controls, t) - space_.evaluate(controls_, t)).norm()
            );
        }
        EXPECT_LT(largest, 1e-13) << "trial " << trial;
    }
}

// Ten halvings of the first span, as when knots pile up at a pick.
TEST_P(SplineSpaces, RefiningOneSpanAgainAndAgainLeavesTheCurveUnchanged) {
    SplineSpace space = space_;
    ControlPoints controls = controls_;
    for (int i = 0; i < 10; ++i) {
        std::vector<double> finer = space.breaks();
        finer.insert(finer.begin() + 1, 0.5 * (finer[0] + finer[1]));
        const SplineSpace next(degree(), closed(), finer);
        controls = refine(space, controls, next);
        space = next;
    }
    for (int i = 0; i <= 1000; ++i) {
        const double t = i / 1000.0;
        EXPECT_LT((space.evaluate(controls, t) - space_.evaluate(controls_, t)).norm(), 1e-12);
    }
}

TEST_P(SplineSpaces, FindTheSpanThatHoldsAParameter) {
    EXPECT_EQ(space_.spanAt(0.0), 0);
    EXPECT_EQ(space_.spanAt(1.0), space_.spanCount() - 1);
    for (int span = 0; span < space_.spanCount(); ++span) {
        EXPECT_EQ(space_.spanAt(space_.breaks()[span]), span);
        EXPECT_EQ(space_.spanAt(space_.breaks()[span] + 0.5 * space_.spanLength(span)), span);
    }
}

INSTANTIATE_TEST_SUITE_P(
    All,
    SplineSpaces,
    testing::Combine(testing::Values(2, 3, 4), testing::Bool()),
    [](const auto& testInfo) {
        return (std::get<1>(testInfo.param) ? "ClosedDegree" : "OpenDegree") +
               std::to_string(std::get<0>(testInfo.param));
    }
);

TEST(SplineSpaceMinimum, ClosedSplinesWithTheFewestSpansArePeriodic) {
    for (const int degree : {2, 3, 4}) {
        Random random(7);
        const SplineSpace space(degree, true, randomBreaks(random, degree + 1, 0.3));
        const ControlPoints controls = randomControls(random, space);
        for (int order = 0; order < degree; ++order) {
            const Vec3 end = derivative(space, controls, space.spanCount() - 1, 1.0, order);
            const Vec3 start = derivative(space, controls, 0, 0.0, order);
            EXPECT_LT((end - start).norm(), 1e-12 * (1.0 + end.norm()));
        }
    }
}

}  // namespace
}  // namespace bspline_curve
