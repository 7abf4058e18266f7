// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "design/field_travel.h"
#include "shell/shell_base.h"
#include "surface/patch_levels.h"
#include "surface/surface_point.h"

#include <optional>
#include <span>
#include <vector>

namespace bspline_curve {

/// Pulls a path taut at a fixed number of points of it, which move over the surface: along a
/// geodesic in the path's neighbourhood, to about a thousandth of its length, or where a field
/// makes lengths cost more, to a path that is cheaper and about the cheapest there. The time
/// hardly depends on how many faces lie between.
///
/// `patches`: see FootFinder. `path`: ascending along the way, two points at least; the first and
/// the last stay. Nothing where the points do not come to rest, or leave the surface over its
/// boundary.
[[nodiscard]] std::optional<std::vector<SurfacePoint>> pullTaut(
    const ShellBase& base,
    const PatchLevels* patches,
    const FieldTravel& field,
    std::span<const SurfacePoint> path
);

}  // namespace bspline_curve
