// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/energy.h"
#include "solver/newton.h"
#include "solver/solution.h"
#include "solver/stop_rule.h"
#include "solver/weight_schedule.h"

#include <limits>

namespace bspline_curve {

/// How solve() goes about one kind of energy.
struct SolvePolicy {
    WeightSchedule schedule;
    bool givesUp = false;  ///< see StopRule
    NewtonPolicy newton;   ///< whose budget ends the rounds as well
    NewtonGoal rough;      ///< of rounds whose integrals are rough
    NewtonGoal round;      ///< of the others
    /// That of rounds after one that stopped where it began, far from the surface: else alpha would
    /// grow in vain.
    double idleDecrement = 0.0;
    NewtonGoal rest;  ///< at last, while frozen directions still change
    /// And when they do so no more; 0: directions are never frozen, so rest is the last goal.
    double fineDecrement = 0.0;
    int restIterations = std::numeric_limits<int>::max();  ///< altogether, at rest
    /// Closes the gaps at the picks that rounding leaves after each minimisation.
    bool meetsPicks = false;
    /// Rounds measure the curve at samples alone; it is traced at rest, and spans that leave the
    /// tolerance are halved. Else all of it is measured in each round, and alpha grows.
    bool tracesAtRestOnly = false;
};

/// Alg. 1 of the paper: minimise, raise the weights, insert knots, until the curve is near enough
/// to the surface and more knots no longer change it; then come to rest. The report says whether
/// the curve is usable; if it is, the solution has its trace. Throws Cancelled.
[[nodiscard]] Solution solve(
    const CurveProblem& problem,
    Energy& energy,
    const EnergyWeights& firstWeights,
    const SolvePolicy& policy
);

}  // namespace bspline_curve
