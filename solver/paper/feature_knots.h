// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/energy.h"

#include <vector>

namespace bspline_curve {

/// The growth (20) of the feature function (19) on each span: how the curve and its shadow differ,
/// and their distance.
struct FeatureFunction {
    std::vector<double> perSpan;
    double total = 0.0;
};

/// By Gauss quadrature at the samples of (14)-(16).
[[nodiscard]] FeatureFunction featureFunction(
    const CurveProblem& problem,
    const SplineSpace& space,
    const ControlPoints& controls,
    const EnergyWeights& weights
);

/// Breaks with as many new ones in each span as (21), (22) ask for, evenly spaced, none shorter
/// than `minimumSpan` (23). `ratio` is r. The integral in (21) is read as the growth over the whole
/// curve: F itself, integrated by t, would depend on where the curve starts.
[[nodiscard]] std::vector<double> insertByFeature(
    const SplineSpace& space, const FeatureFunction& feature, double ratio, double minimumSpan
);

}  // namespace bspline_curve
