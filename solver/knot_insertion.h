// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/cellwise_energy.h"

#include <vector>

namespace bspline_curve {

/// What knots would gain, or by (19) need, span by span.
struct KnotDemand {
    double total = 0.0;
    std::vector<double> perSpan;
    /// How far the most mobile control point of the refined curve would go (predictGain only).
    double largestMove = 0.0;
};

/// Predicts by one Newton step in the space with all spans halved how much the energy would fall,
/// and how the spans share it (by the step's energy norm). One evaluation in the finer space, with
/// the bending directions of the minimisation before; `segments` of the finer spans as in
/// CellwiseEnergy.
[[nodiscard]] KnotDemand predictGain(
    const CurveProblem& problem,
    const SplineSpace& space,
    const ControlPoints& controls,
    const EnergyWeights& weights,
    const BendingDirections& directions,
    int segments
);

/// Breaks with the marked spans halved, but for those whose halves would be shorter than
/// `minimumSpan`.
[[nodiscard]] std::vector<double> halveSpans(
    const SplineSpace& space, const std::vector<char>& marked, double minimumSpan
);

/// Breaks with the spans halved that together promise most of the gain, largest first.
[[nodiscard]] std::vector<double> halveLargest(
    const SplineSpace& space, const KnotDemand& gain, double minimumSpan
);

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
