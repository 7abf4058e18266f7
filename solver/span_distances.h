// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/curve_problem.h"
#include "solver/spline_space.h"

#include <vector>

namespace bspline_curve {

/// How far the curve is from the surface on each span, in the shell's frame.
struct SpanDistances {
    /// Largest |P - M_S(P)| sampled, per span; infinite from the span on which the curve leaves the
    /// shell.
    std::vector<double> distance;
    double largestHeight = 0.0;  ///< largest relative height d (10)

    [[nodiscard]] double largest() const;
};

/// Samples every piece of the curve at its start and middle. Beyond a boundary the distance is that
/// to the boundary.
[[nodiscard]] SpanDistances measureDistances(
    const CurveProblem& problem, const SplineSpace& space, const ControlPoints& controls
);

}  // namespace bspline_curve
