// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/options.h"
#include "design/curve_solver.h"

namespace bspline_curve {

/// What people get of a curve that was solved: its spline, and the polyline on the surface beneath
/// it. Takes its trace. O(n) for n faces passed and samples.
[[nodiscard]] Curve curveOf(
    const Surface& surface, Solved& solved, const SamplingOptions& sampling
);

}  // namespace bspline_curve
