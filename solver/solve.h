// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/solution.h"

namespace bspline_curve {

/// Alg. 1 of the paper: from the first spline along the guide, minimise, raise the weights, insert
/// knots, until the curve is near enough to the surface and more knots no longer change it. Throws
/// Cancelled.
[[nodiscard]] Solution solve(
    const CurveProblem& problem, const GuidePath& guide, SplineCurve first
);

}  // namespace bspline_curve
