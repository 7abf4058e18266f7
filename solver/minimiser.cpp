// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/minimiser.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bspline_curve {
namespace {

// Armijo's constant: the energy must fall by this share of what the slope promises.
constexpr double kSufficientDecrease = 1e-4;
// Share of the negative kink terms that is tried in turn until the Hessian is positive.
constexpr std::array<double, 5> kKinkShares = {1.0, 0.5, 0.25, 0.125, 0.0};
// A^T A enters with this many times the largest diagonal entry, so that two multiplier steps meet
// the picks.
constexpr double kConstraintWeight = 1e3;

}  // namespace

std::optional<Eigen::VectorXd> newtonStep(
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
    std::vector<SpanMatrix> blocks;
    for (const double share : kKinkShares) {
        blocks = derivatives.hessian;
        if (share > 0.0) {
            for (std::size_t span = 0; span < blocks.size(); ++span) {
                blocks[span] += share * derivatives.negativeKinks[span];
            }
        }
        if (system.factorise(blocks, constraintWeight)) {
            return constrained
                       ? system.constrainedStep(
                             derivatives.gradient, system.residual(controls), constraintWeight
                         )
                       : system.solve(-derivatives.gradient);
        }
    }
    return std::nullopt;
}

MinimiseResult minimise(
    const CurveEnergy& energy,
    SplineSystem& system,
    const SplineSpace& space,
    const EnergyWeights& weights,
    Interpolation interpolation,
    const MinimiseOptions& options,
    ControlPoints& controls
) {
    MinimiseResult result;
    // Mostly the whole step is taken, so its derivatives are computed with its value.
    EnergyDerivatives derivatives;
    EnergyDerivatives trialDerivatives;
    ControlPoints trial(space.controlCount(), 3);
    result.value = energy.evaluate(controls, weights, derivatives);
    if (!result.value.inside) {
        result.status = MinimiseStatus::Outside;
        return result;
    }

    for (int iteration = 0; iteration < options.maxIterations; ++iteration) {
        const std::optional<Eigen::VectorXd> step =
            newtonStep(system, derivatives, interpolation, controls);
        if (!step) {
            result.status = MinimiseStatus::NotPositive;
            return result;
        }
        const double slope = derivatives.gradient.dot(*step);
        IterationReport entry;
        entry.total = result.value.total;
        entry.terms = result.value.terms;
        entry.decrement = -0.5 * slope;

        if (entry.decrement <= options.decrementTolerance * result.value.scale) {
            result.iterations.push_back(entry);
            result.status = MinimiseStatus::Converged;
            return result;
        }
        double length = 1.0;
        bool accepted = false;
        EnergyValue value;
        while (length >= options.leastStep) {
            Eigen::Map<Eigen::VectorXd>(trial.data(), trial.size()) =
                Eigen::Map<const Eigen::VectorXd>(controls.data(), controls.size()) +
                length * *step;
            value = length == 1.0 ? energy.evaluate(trial, weights, trialDerivatives)
                                  : energy.evaluate(trial, weights);
            if (value.inside &&
                value.total <= result.value.total + kSufficientDecrease * length * slope) {
                accepted = true;
                break;
            }
            length *= 0.5;
        }
        entry.step = accepted ? length : 0.0;
        result.iterations.push_back(entry);
        if (!accepted) {
            result.status = MinimiseStatus::LineSearchStalled;
            return result;
        }
        controls.swap(trial);
        if (length < 1.0) {
            value = energy.evaluate(controls, weights, trialDerivatives);
        }
        result.value = value;
        std::swap(derivatives, trialDerivatives);
    }
    result.status = MinimiseStatus::IterationLimit;
    return result;
}

}  // namespace bspline_curve
