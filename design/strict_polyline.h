// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/options.h"
#include "design/faired_shadow.h"
#include "solver/curve_problem.h"
#include "surface/surface.h"

namespace bspline_curve {

/// The polyline strictly on the surface (end of Sect. 4.4): crossings of edges, picks and samples
/// of the curve on the surface. Consecutive vertices always share a face. O(n log n) in the number
/// of vertices.
[[nodiscard]] SurfacePolyline makeStrictPolyline(
    const Surface& surface,
    const CurveProblem& problem,
    const FairedShadow& curve,
    const SamplingOptions& sampling
);

}  // namespace bspline_curve
