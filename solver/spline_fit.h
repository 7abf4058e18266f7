// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/initial_curve.h"

#include <array>
#include <vector>

namespace bspline_curve {

/// Weight of squared distances from the picks in a fit; multipliers do the rest.
inline constexpr double kFitConstraintWeight = 1e4;

/// A initial path at samples of a span.
struct SpanTarget {
    /// More than the unknowns of a span, few enough to be cheap.
    static constexpr int kSamples = 16;

    /// Of the initial path between two parameters.
    SpanTarget(const InitialPath& initialPath, double begin, double end);

    /// Parameter of a sample in the span, in [0, 1].
    [[nodiscard]] static double tau(int sample) { return (sample + 0.5) / kSamples; }

    std::array<Vec3, kSamples> positions;
    std::array<Vec3, kMaxBasis> moments;  ///< means of tau^m times the position
};

/// The least-squares fit to targets, one for each span, that passes all picks and bends as little
/// as the samples leave open. O(n) for n spans: the axes share one matrix.
[[nodiscard]] ControlPoints fitSpline(
    const CurveProblem& problem, const SplineSpace& space, const std::vector<SpanTarget>& targets
);

}  // namespace bspline_curve
