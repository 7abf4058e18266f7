// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/progress.h"
#include "surface/surface.h"

#include <span>
#include <vector>

namespace bspline_curve {

/// The exact geodesic distance of each vertex of the surface's input to the nearest of some lines,
/// in the user's unit; infinite where it is more than `reach` (which may be infinite), or where no
/// way leads. Lines are on the input; one with a single vertex is a point. As accurate as
/// DistanceBeams; time grows as k^1.5 for k vertices within reach on a smooth surface.
/// Throws InputError (NoPath where a line is not strict), Cancelled.
[[nodiscard]] std::vector<double> distancesToLines(
    const Surface& surface,
    std::span<const SurfacePolyline> lines,
    double reach,
    const Progress& progress = {}
);

}  // namespace bspline_curve
