// SPDX-License-Identifier: GPL-3.0-or-later
#include "problem_fixture.h"
#include "projection/cell_tracer.h"
#include "solver/barrier.h"
#include "solver/problem_traces.h"
#include "solver/quadrature.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

namespace bspline_curve {
namespace {

// A parabola over a plate of few large faces that comes up to a share `gap` of its height below the
// top of the shell.
class NearTheTop : public testing::TestWithParam<double> {
protected:
    static SolverOptions quadratic() {
        SolverOptions options;
        options.degree = 2;
        return options;
    }

    [[nodiscard]] ControlPoints risingBy(double height) const {
        const Vec3 from = fixture_.problem().picks.front().position;
        const Vec3 to = fixture_.problem().picks.back().position;
        ControlPoints controls(3, 3);
        controls.row(0) = from;
        controls.row(1) = 0.5 * (from + to) + height * Vec3::UnitZ();
        controls.row(2) = to;
        return controls;
    }

    // E_dist by the middle rule, in steps that are fine beside the width of the peak; nothing where
    // the curve leaves the shell.
    [[nodiscard]] std::optional<double> reference(const ControlPoints& controls, int steps) const {
        double sum = 0.0;
        const int spans = traceCurve(
            traceStartOf(fixture_.problem()),
            space_,
            controls,
            [&](int, const PolynomialCurve& curve, const ShellCell& cell, double from, double to) {
                const double step = (to - from) / steps;
                for (int i = 0; i < steps; ++i) {
                    const Vec3 p = curve.at(from + (i + 0.5) * step);
                    sum += barrierValue(cell.relativeHeight(p), 1.0) * step;
                }
            },
            [](int, const PolynomialCurve&, const ShellCell&, const ShellCell&, double, int) {}
        );
        return spans == space_.spanCount() ? std::optional(sum) : std::nullopt;
    }

    test_support::ProblemFixture fixture_{
        test_support::plate(2, 2), {{0.1, 0.3, 0}, {0.9, 0.65, 0}}, quadratic()
    };
    SplineSpace space_{2, false, {0.0, 1.0}};
};

TEST_P(NearTheTop, TheBarrierIsIntegratedToThreeDigits) {
    double inside = 0.0;
    double outside = 1.0;
    for (int step = 0; step < 60; ++step) {
        const double middle = 0.5 * (inside + outside);
        (reference(risingBy(middle), 1) ? inside : outside) = middle;
    }
    const ControlPoints controls = risingBy((1.0 - GetParam()) * inside);
    const std::optional<double> expected = reference(controls, 1'000'000);
    EnergyTerms terms;
    ASSERT_TRUE(integrateCells(fixture_.problem(), space_, controls, {}, terms, nullptr));
    ASSERT_TRUE(expected.has_value());
    EXPECT_NEAR(terms.distance, *expected, 1e-3 * *expected);
}

INSTANTIATE_TEST_SUITE_P(Gaps, NearTheTop, testing::Values(0.5, 0.05, 1e-2, 1e-4, 1e-6));

}  // namespace
}  // namespace bspline_curve
