// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/energy_weights.h"
#include "solver/options.h"
#include "solver/solve_report.h"

namespace bspline_curve {

/// Weights for the first round. `largestHeight` is that of the first curve, 1 where it leaves the
/// shell.
[[nodiscard]] EnergyWeights firstWeights(const SolverOptions& options, double largestHeight);

/// Weights for the next round, from the terms at the end of this one. `near`: the curve is within
/// its tolerance of the surface already, so the schedule for alpha stands still.
[[nodiscard]] EnergyWeights nextWeights(
    const SolverOptions& options,
    const EnergyWeights& now,
    const EnergyTerms& terms,
    double mu,
    double largestHeight,
    bool near
);

}  // namespace bspline_curve
