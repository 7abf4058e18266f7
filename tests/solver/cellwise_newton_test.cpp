// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/cellwise_newton.h"

#include "problem_fixture.h"
#include "solver/cellwise_solver.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace bspline_curve {
namespace {

using namespace test_support;

ProblemFixture noisySphere(const SolverOptions& options, bool withField) {
    ProblemFixture fixture(
        withNoise(icosphere(3), 0.01, 7), {{1, 0.1, 0}, {0, 1, 0.2}, {-0.45, 0.2, 0.87}}, options
    );
    if (withField) {
        std::vector<double> field;
        for (const Vec3& v : fixture.surface().vertices()) {
            field.push_back(1.0 + std::sin(3.0 * v.x()) * v.y());
        }
        fixture.setField(field);
    }
    return fixture;
}

struct Case {
    std::string name;
    SolverOptions options;
    bool withField;
};

Case makeCase(const std::string& name, int degree, bool closed, double tension, bool withField) {
    SolverOptions options;
    options.degree = degree;
    options.closed = closed;
    options.tension = tension;
    return {name, options, withField};
}

class Minimisation : public testing::TestWithParam<Case> {};

TEST_P(Minimisation, NeverRaisesTheEnergy) {
    SolverOptions options = GetParam().options;
    options.quadrature = Quadrature::Cells;
    const ProblemFixture fixture = noisySphere(options, GetParam().withField);
    const Solution solution = solved(fixture);
    const std::vector<IterationReport>& iterations = solution.report.iterations;
    ASSERT_FALSE(iterations.empty());
    int falls = 0;
    for (std::size_t i = 1; i < iterations.size(); ++i) {
        // A step of 0 ends a minimisation; the next one has other weights or directions.
        const IterationReport& before = iterations[i - 1];
        if (before.step > 0.0 && iterations[i].round == before.round) {
            EXPECT_LE(iterations[i].total, before.total) << "iteration " << i;
            ++falls;
        }
    }
    EXPECT_GT(falls, 2);
}

TEST_P(Minimisation, EndsAtAStationaryPointThatMeetsThePicks) {
    SolverOptions options = GetParam().options;
    options.bending = Bending::Ambient;
    const ProblemFixture fixture = noisySphere(options, GetParam().withField);
    SplineCurve curve = fitInitialPath(fixture.problem(), fixture.initialPath()).value();
    const std::vector<InterpolationRow> rows =
        interpolationRows(curve.space, fixture.problem().picks);
    const CellwiseEnergy energy(fixture.problem(), curve.space, rows, 0);
    SplineSystem system(curve.space, rows);
    const EnergyWeights weights{10.0, 0.0, 1.0};
    const double before = energy.evaluate(curve.controls, weights).total;
    const MinimiseResult result =
        minimise(energy, system, weights, Interpolation::Constraint, {100, 1e-8}, curve.controls);
    EXPECT_EQ(result.status, MinimiseStatus::Converged) << name(result.status);
    EXPECT_TRUE(result.value.inside);
    EXPECT_LE(result.value.total, before);
    EXPECT_EQ(result.value.total, energy.evaluate(curve.controls, weights).total);
    EXPECT_LT(system.residual(curve.controls).lpNorm<Eigen::Infinity>(), 1e-9);
    EXPECT_LE(result.iterations.back().decrement, 1e-8 * result.value.total);
}

// Blocks whose least eigenvalue is negative, and no kinks that could be left out.
TEST(NewtonSteps, DescendWhereTheHessianIsIndefinite) {
    const SplineSpace space(3, false, {0.0, 0.2, 0.5, 0.7, 1.0});
    SplineSystem system(space, {});
    const int size = 3 * space.basisCount();
    EnergyDerivatives derivatives;
    derivatives.reset(space);
    for (SpanMatrix& block : derivatives.hessian) {
        for (int i = 0; i < size; ++i) {
            for (int j = i % 3; j < size; j += 3) {
                block(i, j) = i == j ? 1.0 : -1.5;
            }
        }
    }
    ASSERT_FALSE(system.factorise(derivatives.hessian, 0.0));
    derivatives.gradient = Eigen::VectorXd::LinSpaced(3 * space.controlCount(), -1.0, 2.0);
    const ControlPoints controls = ControlPoints::Zero(space.controlCount(), 3);
    const auto step = newtonStep(system, derivatives, Interpolation::Penalty, controls);
    ASSERT_TRUE(step.has_value());
    EXPECT_LT(step->direction.dot(derivatives.gradient), 0.0);
    EXPECT_TRUE(step->isTooShort);
}

TEST_P(Minimisation, StopsAtItsLimitAndSaysSo) {
    const ProblemFixture fixture = noisySphere(GetParam().options, GetParam().withField);
    SplineCurve curve = fitInitialPath(fixture.problem(), fixture.initialPath()).value();
    const std::vector<InterpolationRow> rows =
        interpolationRows(curve.space, fixture.problem().picks);
    const CellwiseEnergy energy(fixture.problem(), curve.space, rows, 0);
    SplineSystem system(curve.space, rows);
    const MinimiseResult result = minimise(
        energy, system, {10.0, 0.0, 1.0}, Interpolation::Constraint, {1, 0.0}, curve.controls
    );
    EXPECT_EQ(result.status, MinimiseStatus::IterationLimit) << name(result.status);
    EXPECT_EQ(result.iterations.size(), 1U);
}

INSTANTIATE_TEST_SUITE_P(
    All,
    Minimisation,
    testing::Values(
        makeCase("Cubic", 3, false, 0.0, false),
        makeCase("QuadraticTense", 2, false, 0.6, false),
        makeCase("QuarticClosed", 4, true, 0.0, false),
        makeCase("CubicField", 3, false, 0.2, true)
    ),
    [](const auto& testInfo) { return testInfo.param.name; }
);

}  // namespace
}  // namespace bspline_curve
