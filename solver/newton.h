// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/energy.h"

#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace bspline_curve {

/// What minimise() does about indefinite Hessians and steps that fail.
struct NewtonPolicy {
    /// Shares of the Hessian's negative part, tried in turn until it is positive definite.
    std::span<const double> negativeShares;
    /// Shares by which the diagonal then grows in turn, as Levenberg and Marquardt have it.
    std::span<const double> ridges;
    /// So often spans are damped where a whole step fails, before it is shortened.
    int mostDampings = 0;
    /// A whole step by a Hessian that lacks its negative part is doubled up to this length.
    double longestStep = 1.0;
    /// Takes the step that promises too little as well, as it is known by then.
    bool takesLastStep = false;
    /// After so much work of the energy (Energy::work()) no step begins but the first one.
    double mostWork = std::numeric_limits<double>::infinity();
    /// Kinks make steps short again and again: these promise less, and damping is of no use.
    bool hasShortSteps = false;
};

/// When minimise() stops.
struct NewtonGoal {
    double decrement = 1e-9;  ///< where a step promises less than this share of the energy
    int mostIterations = 100;
    double leastStep = 1e-10;  ///< where no step of at least this length lowers the energy enough
    double keptPromise = 0.0;  ///< where a step brought less than this share of its promise
    int gainlessSteps = 0;     ///< where so many steps gain less than one should; 0: never
};

struct MinimiseResult {
    MinimiseStatus status = MinimiseStatus::IterationLimit;
    EnergyValue value;
    std::vector<IterationReport> iterations;
};

/// Whether mostWork is done.
[[nodiscard]] bool isOverBudget(const Energy& energy, const NewtonPolicy& policy);

struct NewtonStep {
    Eigen::VectorXd direction;
    double negativeShare = 1.0;
    bool isTooShort = false;  ///< the Hessian was made larger than it is
};

/// The Newton step after Energy::differentiate(); where the picks are constraints they stay met.
/// Nothing where the Hessian is positive definite by no means of the policy.
[[nodiscard]] std::optional<NewtonStep> newtonStep(
    Energy& energy, Interpolation interpolation, const NewtonPolicy& policy
);

/// Newton's method with backtracking (17): the spline ends at the last feasible iterate. Where the
/// picks are constraints they are eliminated from each step; where they are a penalty, beta is in
/// the energy. No step raises the energy with the directions frozen as they are before it.
[[nodiscard]] MinimiseResult minimise(
    Energy& energy,
    const EnergyWeights& weights,
    Interpolation interpolation,
    const NewtonPolicy& policy,
    const NewtonGoal& goal
);

}  // namespace bspline_curve
