// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

#include <span>
#include <utility>
#include <vector>

namespace bspline_curve {

/// The point between two others of a line that is farthest from the segment between them, and how
/// far; -1 where there is none. O(to - from).
[[nodiscard]] std::pair<int, double> farthestBetween(std::span<const Vec3> line, int from, int to);

/// Further points of a line, so that the polyline through them and those that are kept, ascending,
/// is within a distance of all between (D. Douglas, T. Peucker, 1973). Returns all, ascending.
/// O(n log n) on most lines.
[[nodiscard]] std::vector<int> simplified(
    std::span<const Vec3> line, std::vector<int> kept, double within
);

}  // namespace bspline_curve
