// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/cellwise_energy.h"

#include <optional>

namespace bspline_curve {

struct NewtonStep {
    Eigen::VectorXd direction;
    bool isTooShort = false;  ///< the Hessian was made larger than it is
};

/// The Newton step at a curve: the negative kink terms are halved a few times, then dropped, until
/// the Hessian is positive definite; the picks stay met. Nothing where it never is.
[[nodiscard]] std::optional<NewtonStep> newtonStep(
    SplineSystem& system,
    const EnergyDerivatives& derivatives,
    Interpolation interpolation,
    const ControlPoints& controls
);

struct MinimiseOptions {
    int maxIterations = 100;
    /// Stop where the Newton decrement falls below this share of the energy.
    double decrementTolerance = 1e-9;
    /// The line search gives up below this share of the whole step.
    double leastStep = 1e-10;
};

struct MinimiseResult {
    MinimiseStatus status = MinimiseStatus::IterationLimit;
    EnergyValue value;
    std::vector<IterationReport> iterations;
};

/// Newton's method with backtracking (17) from a curve inside the shell; `controls` ends as the
/// last feasible iterate. Where the picks are constraints they are eliminated from each step; where
/// they are a penalty, beta is in the energy. The energy never rises.
[[nodiscard]] MinimiseResult minimise(
    const CellwiseEnergy& energy,
    SplineSystem& system,
    const EnergyWeights& weights,
    Interpolation interpolation,
    const MinimiseOptions& options,
    ControlPoints& controls
);

}  // namespace bspline_curve
