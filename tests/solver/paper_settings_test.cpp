// SPDX-License-Identifier: GPL-3.0-or-later
// What the paper's own settings and weak fields change in the loop of rounds.
#include "problem_fixture.h"
#include "solver/cellwise_energy.h"
#include "solver/cellwise_solver.h"
#include "solver/solve_variant.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

ProblemFixture problemOnASphere(const SolverOptions& options) {
    return {
        withNoise(icosphere(3), 0.01, 7), {{1, 0.1, 0}, {0, 1, 0.2}, {-0.45, 0.2, 0.87}}, options
    };
}

bool claimsToBeNear(const SolveReport& report) {
    return report.status == SolveStatus::Converged || report.status == SolveStatus::DistanceReached;
}

void expectReportOfCurve(const SolverOptions& options) {
    const ProblemFixture fixture = problemOnASphere(options);
    const Solution solution = solved(fixture);
    const SolveReport& report = solution.report;
    EXPECT_EQ(report.usable, claimsToBeNear(report)) << name(report.status);
    EXPECT_LT(report.maxPickGap, 1e-9);
    CellwiseEnergy again(fixture.problem(), solution.curve, 0.0);
    const double distance = again.trace().largest / fixture.problem().averageEdgeLength;
    EXPECT_NEAR(report.maxDistance, distance, 1e-12);
    EXPECT_EQ(report.usable, distance < options.distanceTolerance);
}

TEST(PickPenalty, ReportsTheCurveThatItReturns) {
    for (const double tolerance : {0.3, 0.1, 0.03, 0.01, 0.003, 0.001}) {
        SCOPED_TRACE(tolerance);
        SolverOptions options;
        options.distanceTolerance = tolerance;
        options.interpolation = Interpolation::Penalty;
        expectReportOfCurve(options);
        options.closed = true;
        expectReportOfCurve(options);
    }
}

// No such option is ignored where its code is missing.
TEST(SolveVariants, AreMissedWhereOptionsNeedOne) {
    CurveProblem problem;
    EXPECT_FALSE(needsVariant(problem.options));
    EXPECT_NO_THROW((void)variantOf(problem));
    problem.options.interpolation = Interpolation::Penalty;
    EXPECT_TRUE(needsVariant(problem.options));
    EXPECT_THROW((void)variantOf(problem), std::logic_error);
    EXPECT_TRUE(needsVariant(paperPreset()));
    problem.options = SolverOptions();
    problem.options.quadrature = Quadrature::Cells;
    EXPECT_FALSE(needsVariant(problem.options));
}

// A field that hardly counts leaves the curve as exact as none does.
TEST(WeakFields, DoNotLoosenTheLastMinimisation) {
    SolverOptions options;
    options.quadrature = Quadrature::Cells;
    options.fieldWeight = 1.0;
    ProblemFixture fixture = problemOnASphere(options);
    std::vector<double> field;
    for (const Vec3& v : fixture.surface().vertices()) {
        field.push_back(1.0 + std::sin(3.0 * v.x()) * v.y());
    }
    fixture.setField(field);
    const Solution solution = solved(fixture);
    ASSERT_EQ(solution.report.status, SolveStatus::Converged);
    const IterationReport& last = solution.report.iterations.back();
    EXPECT_LT(last.decrement, 3e-6 * last.total);
}

}  // namespace
}  // namespace bspline_curve
