// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/shell_base.h"
#include "solver/curve_problem.h"
#include "surface/surface_point.h"

#include <optional>
#include <span>
#include <vector>

namespace bspline_curve {

/// Pulls a path of many faces taut: the polyline of a fixed number of segments, near the surface,
/// that minimises E_int (4) with full tension, and E_ext where `problem` has a field, from the path
/// on. Its feet stand for the geodesic in the path's neighbourhood, to about a thousandth of its
/// length; the time does not depend on how many faces lie between.
///
/// `problem`: base, field, its cost and weight. `path`: consecutive points, first and last stay.
/// Nothing where the polyline does not come to rest on the surface.
[[nodiscard]] std::optional<std::vector<SurfacePoint>> pullTaut(
    CurveProblem problem, std::span<const SurfacePoint> path
);

}  // namespace bspline_curve
