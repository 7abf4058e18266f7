// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/cellwise_newton.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace bspline_curve {
namespace {

// Armijo's constant: the energy must fall by this share of what the slope promises.
constexpr double kSufficientDecrease = 1e-4;
// Share of the negative kink terms that is tried in turn until the Hessian is positive. Damping
// them only on the spans that make it indefinite took a tenth more iterations.
constexpr std::array<double, 5> kKinkShares = {1.0, 0.5, 0.25, 0.125, 0.0};
// Without the kinks the Hessian may still be indefinite: in ways between faces to avoid that are
// one face wide the closeness bends downwards. The diagonal grows by these shares in turn, as
// Levenberg and Marquardt do.
constexpr std::array<double, 3> kRidges = {1e-2, 1.0, 1e2};
// A^T A enters with this many times the largest diagonal entry, so that two multiplier steps meet
// the picks.
constexpr double kConstraintWeight = 1e3;

// A whole step after which the energy still falls by this share of the slope before it was too
// short: the Hessian was made positive by leaving kinks out.
constexpr double kSteepShare = 0.5;
constexpr double kLongestStep = 64.0;

// Where a minimisation stands, and where it may go next.
struct State {
    ControlPoints& controls;
    EnergyValue& value;
    EnergyDerivatives& derivatives;
    ControlPoints& trial;
    EnergyDerivatives& trialDerivatives;

    void tryMove(const Eigen::VectorXd& step, double length) {
        Eigen::Map<Eigen::VectorXd>(trial.data(), trial.size()) =
            Eigen::Map<const Eigen::VectorXd>(controls.data(), controls.size()) + length * step;
    }

    // Whether the energy falls enough for a move of this length.
    [[nodiscard]] bool isBetter(const EnergyValue& tried, double length, double slope) const {
        return tried.inside && tried.total <= value.total + kSufficientDecrease * length * slope;
    }

    // With the derivatives of the trial.
    void accept(const EnergyValue& tried) {
        controls.swap(trial);
        std::swap(derivatives, trialDerivatives);
        value = tried;
    }
};

struct LineSearch {
    const CellwiseEnergy& energy;
    const EnergyWeights& weights;
    double leastStep;
};

// Moves along a step as far as the energy falls enough; `slope` is that of the energy along the
// step. Returns the share of the step taken, 0 where there is none. Mostly it is the whole step, so
// its derivatives are computed with its value.
double takeStep(const LineSearch& search, const Eigen::VectorXd& step, double slope, State& state) {
    for (double length = 1.0; length >= search.leastStep; length *= 0.5) {
        state.tryMove(step, length);
        EnergyValue value =
            length == 1.0
                ? search.energy.evaluate(state.trial, search.weights, state.trialDerivatives)
                : search.energy.evaluate(state.trial, search.weights);
        if (!state.isBetter(value, length, slope)) {
            continue;
        }
        if (length < 1.0) {
            value = search.energy.evaluate(state.trial, search.weights, state.trialDerivatives);
        }
        state.accept(value);
        return length;
    }
    return 0.0;
}

// Where the energy still falls steeply at the end of a whole step, goes on along it: twice as far
// each time, while that lowers the energy. Returns the length of the step that was taken.
double lengthenStep(
    const LineSearch& search, const Eigen::VectorXd& step, double slope, State& state
) {
    double length = 1.0;
    while (state.derivatives.gradient.dot(step) < kSteepShare * slope && length < kLongestStep) {
        state.tryMove(step, length);
        const EnergyValue value =
            search.energy.evaluate(state.trial, search.weights, state.trialDerivatives);
        if (!state.isBetter(value, length, slope)) {
            break;
        }
        state.accept(value);
        length *= 2.0;
    }
    return length;
}

}  // namespace

std::optional<NewtonStep> newtonStep(
    SplineSystem& system,
    const EnergyDerivatives& derivatives,
    Interpolation interpolation,
    const ControlPoints& controls
) {
    const bool constrained = interpolation == Interpolation::Constraint;
    double largest = 0.0;
    for (const SpanMatrix& block : derivatives.hessian) {
        largest = std::max(largest, block.diagonal().maxCoeff());
    }
    const double constraintWeight = constrained ? kConstraintWeight * largest : 0.0;
    std::vector<SpanMatrix> blocks = derivatives.hessian;
    const auto solveBlocks = [&]() -> std::optional<Eigen::VectorXd> {
        if (!system.factorise(blocks, constraintWeight)) {
            return std::nullopt;
        }
        return constrained ? system.constrainedStep(
                                 derivatives.gradient, system.residual(controls), constraintWeight
                             )
                           : system.solve(-derivatives.gradient);
    };
    double added = 0.0;
    for (const double share : kKinkShares) {
        for (std::size_t span = 0; span < blocks.size(); ++span) {
            blocks[span] += (share - added) * derivatives.negativeKinks[span];
        }
        added = share;
        if (std::optional<Eigen::VectorXd> step = solveBlocks()) {
            return NewtonStep{std::move(*step), share < 1.0};
        }
    }
    for (const double ridge : kRidges) {
        for (SpanMatrix& block : blocks) {
            block.diagonal() *= 1.0 + ridge;
        }
        if (std::optional<Eigen::VectorXd> step = solveBlocks()) {
            return NewtonStep{std::move(*step), true};
        }
    }
    return std::nullopt;
}

MinimiseResult minimise(
    const CellwiseEnergy& energy,
    SplineSystem& system,
    const EnergyWeights& weights,
    Interpolation interpolation,
    const MinimiseOptions& options,
    ControlPoints& controls
) {
    MinimiseResult result;
    EnergyDerivatives derivatives;
    EnergyDerivatives trialDerivatives;
    ControlPoints trial(controls.rows(), 3);
    State state{controls, result.value, derivatives, trial, trialDerivatives};
    result.value = energy.evaluate(controls, weights, derivatives);
    if (!result.value.inside) {
        result.status = MinimiseStatus::Outside;
        return result;
    }

    for (int iteration = 0; iteration < options.maxIterations; ++iteration) {
        const std::optional<NewtonStep> step =
            newtonStep(system, derivatives, interpolation, controls);
        if (!step) {
            result.status = MinimiseStatus::NotPositive;
            return result;
        }
        const double slope = derivatives.gradient.dot(step->direction);
        IterationReport entry;
        entry.total = result.value.total;
        entry.terms = result.value.terms;
        entry.decrement = -0.5 * slope;

        if (entry.decrement <= options.decrementTolerance * result.value.scale) {
            result.iterations.push_back(entry);
            result.status = MinimiseStatus::Converged;
            return result;
        }
        const LineSearch search{energy, weights, options.leastStep};
        entry.step = takeStep(search, step->direction, slope, state);
        if (entry.step == 1.0 && step->isTooShort) {
            entry.step = lengthenStep(search, step->direction, slope, state);
        }
        result.iterations.push_back(entry);
        if (entry.step == 0.0) {
            result.status = MinimiseStatus::LineSearchStalled;
            return result;
        }
    }
    result.status = MinimiseStatus::IterationLimit;
    return result;
}

}  // namespace bspline_curve
