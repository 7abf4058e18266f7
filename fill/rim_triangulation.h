// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

#include <array>
#include <set>
#include <vector>

namespace bspline_curve {

/// Edges between points, each (lower, higher).
using EdgeSet = std::set<std::array<int, 2>>;

/// So many points of a polygon are triangulated in tenths of a second.
inline constexpr int kMostRimPoints = 400;

/// A triangulation of a closed polygon in space without new points, of least area (G. Barequet and
/// M. Sharir, Filling gaps in the boundary of a polyhedron, 1995). Triangles name points by their
/// place in the polygon and pass its edges in its order. No triangle has an edge of `forbidden` as
/// a chord, or is flat. Polygons of more than `most` points are
/// triangulated with so many of them first, then the rest. O(n^3) up to there. Empty where there is
/// no such triangulation.
[[nodiscard]] std::vector<Triangle> triangulateRim(
    const std::vector<Vec3>& polygon, const EdgeSet& forbidden, int most = kMostRimPoints
);

}  // namespace bspline_curve
