// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "design/field_travel.h"
#include "shell/extended_surface.h"
#include "surface/patch_levels.h"
#include "surface/surface_point.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace bspline_curve {

/// Points on the surface, along a way.
struct ShortenedPath {
    std::vector<SurfacePoint> points;
    /// Ascending i: whether a way along the surface leads straight from points[i] to points[i + 1]
    /// is not known, as between the two sides of a sharp edge or of a thin plate's rim.
    std::vector<std::size_t> gaps;
};

/// Shortens a path by moving a fixed number of its points over the surface: to a geodesic in the
/// path's neighbourhood, up to about a thousandth of its length, or where a field makes lengths
/// cost more, to a path that is cheaper and about the cheapest there. The time hardly depends on
/// how many faces lie between.
///
/// `patches`: see FibreProjector. `path`: ascending along the way, two points at least; the first
/// and the last stay. Nothing where the points do not come to rest, or leave the surface over its
/// boundary.
[[nodiscard]] std::optional<ShortenedPath> shortenPath(
    const ExtendedSurface& extended,
    const PatchLevels* patches,
    const FieldTravel& field,
    std::span<const SurfacePoint> path
);

}  // namespace bspline_curve
