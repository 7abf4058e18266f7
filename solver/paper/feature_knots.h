// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/energy.h"

#include <vector>

namespace bspline_curve {

/// The feature function (19), (20) of each span: how the curve and its shadow differ, and their
/// distance.
[[nodiscard]] KnotDemand featureFunction(
    const CurveProblem& problem,
    const SplineSpace& space,
    const ControlPoints& controls,
    const EnergyWeights& weights
);

/// Breaks with as many new ones in each span as (21), (22) ask for with r = 1, evenly spaced, none
/// shorter than `minimumSpan` (23).
[[nodiscard]] std::vector<double> insertByFeature(
    const SplineSpace& space, const KnotDemand& feature, double minimumSpan
);

}  // namespace bspline_curve
