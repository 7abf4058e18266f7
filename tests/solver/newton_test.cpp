// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/newton.h"

#include "problem_fixture.h"
#include "solver/cellwise_energy.h"
#include "solver/cellwise_solver.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace bspline_curve {
namespace {

using namespace test_support;

ProblemFixture sphereProblem(const SolverOptions& options, bool withField) {
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

struct NewtonCase {
    std::string name;
    SolverOptions options;
    bool withField;
};

NewtonCase makeCase(
    const std::string& name, int degree, bool closed, double tension, bool withField
) {
    SolverOptions options;
    options.degree = degree;
    options.closed = closed;
    options.tension = tension;
    return {name, options, withField};
}

constexpr EnergyWeights kWeights{10.0, 0.0, 1.0};

CellwiseEnergy firstEnergy(const ProblemFixture& fixture) {
    return {
        fixture.problem(), fitInitialPath(fixture.problem(), fixture.initialPath()).value(), 0.0
    };
}

class Minimisation : public testing::TestWithParam<NewtonCase> {};

TEST_P(Minimisation, NeverRaisesTheEnergy) {
    SolverOptions options = GetParam().options;
    options.quadrature = Quadrature::Cells;
    const ProblemFixture fixture = sphereProblem(options, GetParam().withField);
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
    const ProblemFixture fixture = sphereProblem(options, GetParam().withField);
    CellwiseEnergy energy = firstEnergy(fixture);
    energy.setWeights(kWeights);
    const double before = energy.differentiate().total;
    const MinimiseResult result =
        minimise(energy, kWeights, Interpolation::Constraint, cellwiseNewton(), {1e-8, 100});
    EXPECT_EQ(result.status, MinimiseStatus::Converged) << name(result.status);
    EXPECT_TRUE(result.value.inside);
    EXPECT_LE(result.value.total, before);
    energy.setWeights(kWeights);
    EXPECT_EQ(result.value.total, energy.differentiate().total);
    EXPECT_LT(energy.picks().residual(energy.controls()).lpNorm<Eigen::Infinity>(), 1e-9);
    EXPECT_LE(result.iterations.back().decrement, 1e-8 * result.value.total);
}

// A quadratic energy whose Hessian is the same on each span and has a negative eigenvalue, and no
// negative part that could be left out.
class Saddle final : public Energy {
public:
    explicit Saddle(const CurveProblem& problem)
        : Energy(problem, SplineSpace(3, false, {0.0, 0.2, 0.5, 0.7, 1.0})),
          controls_(ControlPoints::Zero(space().controlCount(), 3)) {
        derivatives_.reset(space());
        derivatives_.gradient = Eigen::VectorXd::LinSpaced(controls_.size(), -1.0, 2.0);
        for (SpanBlocks& blocks : derivatives_.hessian) {
            for (int j = 0; j < space().basisCount(); ++j) {
                for (int k = 0; k <= j; ++k) {
                    const double value = j == k ? 1.0 : -1.5;
                    blocks[blockIndex(j, k)] = {value, 0.0, 0.0, value, 0.0, value};
                }
            }
        }
    }

    [[nodiscard]] const ControlPoints& controls() const override { return controls_; }

    void setControls(const ControlPoints& controls) override { controls_ = controls; }

    EnergyValue differentiate() override { return {true, 0.0, 1.0, {}}; }

    [[nodiscard]] const std::vector<SpanBlocks>& hessian(double /*negativeShare*/) override {
        return derivatives_.hessian;
    }

    EnergyValue tryStep(const Eigen::VectorXd& /*step*/, double /*length*/) override { return {}; }

    void acceptStep() override {}

    [[nodiscard]] CurveDistance measure() override { return {}; }

    [[nodiscard]] CurveDistance trace() override { return {}; }

    [[nodiscard]] KnotDemand refinementGain() override { return {}; }

    void insertKnots(SplineSpace /*finer*/) override {}

private:
    ControlPoints controls_;
};

TEST(NewtonSteps, DescendWhereTheHessianIsIndefinite) {
    const CurveProblem problem;
    Saddle energy(problem);
    ASSERT_FALSE(energy.system().factorise(energy.hessian(1.0), 0.0));
    const auto step = newtonStep(energy, Interpolation::Penalty, cellwiseNewton());
    ASSERT_TRUE(step.has_value());
    EXPECT_LT(step->direction.dot(energy.derivatives().gradient), 0.0);
    EXPECT_TRUE(step->isTooShort);
}

TEST(NewtonSteps, AreNoneWhereNoRidgeIsAllowed) {
    const CurveProblem problem;
    Saddle energy(problem);
    NewtonPolicy policy = cellwiseNewton();
    policy.ridges = {};
    EXPECT_FALSE(newtonStep(energy, Interpolation::Penalty, policy).has_value());
    const MinimiseResult result = minimise(energy, {}, Interpolation::Penalty, policy, {});
    EXPECT_EQ(result.status, MinimiseStatus::NotPositive) << name(result.status);
}

TEST(NewtonSteps, StallWhereNoTrialIsInside) {
    const CurveProblem problem;
    Saddle energy(problem);
    const MinimiseResult result =
        minimise(energy, {}, Interpolation::Penalty, cellwiseNewton(), {});
    EXPECT_EQ(result.status, MinimiseStatus::LineSearchStalled) << name(result.status);
    ASSERT_EQ(result.iterations.size(), 1U);
    EXPECT_EQ(result.iterations.front().step, 0.0);
}

TEST_P(Minimisation, StopsAtItsLimitAndSaysSo) {
    const ProblemFixture fixture = sphereProblem(GetParam().options, GetParam().withField);
    CellwiseEnergy energy = firstEnergy(fixture);
    const MinimiseResult result =
        minimise(energy, kWeights, Interpolation::Constraint, cellwiseNewton(), {0.0, 1});
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
