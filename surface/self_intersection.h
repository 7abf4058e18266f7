// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

#include <utility>
#include <vector>

namespace bspline_curve {

/// Whether two triangles meet anywhere but in the corners and the edge that they share by index.
/// Exact: decided by adaptive-precision orientation predicates (orient3d, orient2d) alone.
/// Triangles must have area.
[[nodiscard]] bool trianglesIntersect(
    const std::vector<Vec3>& vertices, const Triangle& a, const Triangle& b
);

/// All pairs (i < j), ascending, of triangles of a set that intersect in the sense of
/// trianglesIntersect. O(n log n) on meshes whose triangles overlap few boxes.
[[nodiscard]] std::vector<std::pair<int, int>> findSelfIntersections(
    const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles
);

}  // namespace bspline_curve
