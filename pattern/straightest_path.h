// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "offset/surface_fan.h"
#include "surface/surface.h"

#include <optional>
#include <vector>

namespace bspline_curve {

/// A straightest geodesic: straight in the faces and over edges laid out flat; at a vertex the
/// angles to its left and to its right are equal.
struct StraightestPath {
    std::vector<SurfacePoint> points;  ///< start, where it passes edges and vertices, end
    double length = 0.0;               ///< less than asked for where the boundary ends it
    bool isWhole = true;               ///< it did not come to the boundary
};

/// The straightest geodesic from a point, into the direction at an angle of the point's fan, up to
/// a length (K. Polthier & M. Schmies 1998, Straightest Geodesics on Polyhedral Surfaces, Def. 9).
/// A boundary, also a vertex on it, ends it. `fan` must be fanOf(surface, start). Exact up to
/// rounding. O(faces passed).
[[nodiscard]] StraightestPath straightestPath(
    const Surface& surface,
    const SurfacePoint& start,
    const SurfaceFan& fan,
    double angle,
    double length
);

/// The angle in a point's fan at which the surface leads into a direction in space, seen along the
/// point's normal. None where the direction is that of the normal, or leads off the boundary.
[[nodiscard]] std::optional<double> angleOfDirection(
    const Surface& surface, const SurfaceFan& fan, const Vec3& direction
);

}  // namespace bspline_curve
