// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

namespace bspline_curve {

struct ClosestPointOnTriangle {
    /// Each in [0, 1], sum 1 up to rounding; in the order of the triangle's vertices.
    Vec3 barycentric;
    /// The sum of barycentric times vertex.
    Vec3 position;
    /// Between the query and position.
    double squaredDistance;
};

/// The point of a triangle that is closest to a query. Triangles that share the edge or vertex on
/// which the point lies give bitwise the same position. Needles and triangles without area are no
/// exception: the result is never farther than the closest point of the three edges.
[[nodiscard]] ClosestPointOnTriangle closestPointOnTriangle(
    const std::vector<Vec3>& vertices, const Triangle& triangle, const Vec3& query
);

}  // namespace bspline_curve
