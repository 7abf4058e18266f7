// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"
#include "utility/disjoint_sets.h"

#include <vector>

namespace bspline_curve {

/// Sets of vertices that are joined by steps of at most `distance` >= 0 from vertex to vertex. The
/// coordinates must be finite. O(n log n) where few are near to each other, or many at one place.
[[nodiscard]] DisjointSets nearVertices(const std::vector<Vec3>& vertices, double distance);

}  // namespace bspline_curve
