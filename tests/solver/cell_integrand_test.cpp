// SPDX-License-Identifier: GPL-3.0-or-later
// The functions under the integrals: barrier and cost of the field.
#include "solver/barrier.h"
#include "solver/field_cost.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace bspline_curve {
namespace {

TEST(BarrierFunction, IsXTanXScaledToItsWidth) {
    for (const double h : {1.0, 0.4, 0.03}) {
        for (const double share : {-0.9, -0.3, 0.0, 0.1, 0.5, 0.99}) {
            const double angle = 0.5 * std::numbers::pi * share;
            EXPECT_NEAR(barrierValue(share * h, h), angle * std::tan(angle), 1e-12);
            EXPECT_EQ(barrier(share * h, h).value, barrierValue(share * h, h));
        }
    }
}

TEST(BarrierFunction, IsEvenAndZeroAtZero) {
    EXPECT_EQ(barrier(0.0, 0.7).value, 0.0);
    EXPECT_EQ(barrier(0.0, 0.7).slope, 0.0);
    for (const double x : {0.01, 0.3, 0.69}) {
        EXPECT_EQ(barrier(-x, 0.7).value, barrier(x, 0.7).value);
        EXPECT_EQ(barrier(-x, 0.7).slope, -barrier(x, 0.7).slope);
        EXPECT_EQ(barrier(-x, 0.7).curvature, barrier(x, 0.7).curvature);
    }
}

TEST(BarrierFunction, IsInfiniteAtItsWidth) {
    for (const double h : {1.0, 0.4}) {
        double before = 0.0;
        for (double gap = 0.1; gap > 1e-12; gap *= 0.1) {
            const double value = barrierValue(h * (1.0 - gap), h);
            EXPECT_GT(value, 0.5 / gap);
            EXPECT_GT(value, before);
            before = value;
        }
        EXPECT_GT(barrierValue(h, h), 1e15);
    }
}

TEST(BarrierFunction, HasTheDerivativesOfItsDifferences) {
    for (const double h : {1.0, 0.4}) {
        for (const double share : {-0.95, -0.4, 0.0, 0.2, 0.8}) {
            const double x = share * h;
            const double step = 1e-6 * h;
            const Barrier here = barrier(x, h);
            const Barrier up = barrier(x + step, h);
            const Barrier down = barrier(x - step, h);
            EXPECT_NEAR(
                (up.value - down.value) / (2.0 * step), here.slope, 1e-7 * (1.0 + here.curvature)
            );
            EXPECT_NEAR(
                (up.slope - down.slope) / (2.0 * step), here.curvature, 1e-7 * here.curvature
            );
            EXPECT_GT(here.curvature, 0.0);
        }
    }
}

TEST(FieldCosts, HaveTheValuesAndDerivativesOfTheirFunctions) {
    for (const double x : {-2.0, -0.3, 0.0, 0.7, 3.0}) {
        EXPECT_EQ(fieldCost(FieldCost::Identity, x).value, x);
        EXPECT_EQ(fieldCost(FieldCost::Square, x).value, x * x);
        EXPECT_EQ(fieldCost(FieldCost::ExpMinus, x).value, std::exp(-x));
        for (const FieldCost kind : {FieldCost::Identity, FieldCost::Square, FieldCost::ExpMinus}) {
            const double step = 1e-5;
            const FieldCostValue up = fieldCost(kind, x + step);
            const FieldCostValue down = fieldCost(kind, x - step);
            const FieldCostValue here = fieldCost(kind, x);
            EXPECT_NEAR((up.value - down.value) / (2.0 * step), here.slope, 1e-8);
            EXPECT_NEAR((up.slope - down.slope) / (2.0 * step), here.curvature, 1e-8);
        }
    }
}

}  // namespace
}  // namespace bspline_curve
