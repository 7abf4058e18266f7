// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"
#include "utility/go_on.h"

#include <array>
#include <functional>
#include <set>
#include <vector>

namespace bspline_curve {

/// Edges between points, each (lower, higher).
using EdgeSet = std::set<std::array<int, 2>>;

/// So many points of a polygon are triangulated in hundredths of a second.
inline constexpr int kMostRimPoints = 160;

/// Whether a triangulation may have a triangle, given by three places in the polygon.
using TriangleTest = std::function<bool(const Triangle&)>;

/// A triangulation of a closed polygon in space without new points, which bends least: its largest
/// angle between neighbours is least, then its area (P. Liepa, Filling holes in meshes, 2003; each
/// part of the polygon goes on with its own best one). Triangles name points by their place in the
/// polygon and pass its edges in its order. No triangle has an edge of `forbidden` as a chord, is
/// flat, or fails the test where there is one. Polygons of more than `most` points are triangulated
/// with so many of them first, then the rest. O(n^3) up to there; the test is asked O(n^2 log n)
/// times. `goOn` is called within milliseconds, where there is no test. Empty where there is no
/// such triangulation.
[[nodiscard]] std::vector<Triangle> triangulateRim(
    const std::vector<Vec3>& polygon,
    const EdgeSet& forbidden,
    const GoOn& goOn,
    int most = kMostRimPoints,
    const TriangleTest& isAllowed = {}
);

/// Faces and those within some rings around, across edges, ascending. O(n log n) a ring.
[[nodiscard]] std::vector<int> grown(
    const std::vector<Triangle>& faces, const std::vector<int>& region, int rings
);

/// A triangulation of a polygon that has no other points than `points`, of which a region (faces,
/// ascending) is triangulated anew as by triangulateRim(). Empty where some part of it cannot be.
[[nodiscard]] std::vector<Triangle> retriangulated(
    const std::vector<Vec3>& points,
    const std::vector<Triangle>& faces,
    const EdgeSet& forbidden,
    const std::vector<int>& region,
    const TriangleTest& isAllowed,
    const GoOn& goOn
);

}  // namespace bspline_curve
