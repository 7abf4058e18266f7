// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/options.h"
#include "bspline_curve/report.h"
#include "solver/energy_weights.h"

namespace bspline_curve {

/// Weights for the first round. `largestHeight` is that of the first curve, 1 where it leaves the
/// shell.
[[nodiscard]] EnergyWeights firstWeights(const SolverOptions& options, double largestHeight);

/// By what factor alpha grows from one round to the next where it follows the schedule.
/// `distanceRatio`: the distance of curve and surface relative to its tolerance; below 1 alpha
/// stands still. `gentle`: in the last rounds no more than brings the distance below the tolerance.
[[nodiscard]] double alphaStep(double distanceRatio, bool gentle);

/// Weights for the next round, from the terms at the end of this one.
[[nodiscard]] EnergyWeights nextWeights(
    const SolverOptions& options,
    const EnergyWeights& now,
    const EnergyTerms& terms,
    double mu,
    double largestHeight,
    double alphaStep
);

}  // namespace bspline_curve
