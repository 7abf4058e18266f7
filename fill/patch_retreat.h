// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"
#include "bspline_curve/progress.h"

#include <functional>
#include <vector>

namespace bspline_curve {

/// Faces of a patch that cross something, given the positions of its points.
using CrossingFaces = std::function<std::vector<int>(const std::vector<Vec3>& points)>;

/// Points on straight ways from a patch that crosses nothing to one that may: as far along as they
/// can go with little effort. Where faces cross, their corners go back, and those around them less.
/// Returns the first positions where all else crosses. At most 12 rounds of O(n) and one search for
/// crossings each. Throws Cancelled.
[[nodiscard]] std::vector<Vec3> retreated(
    const std::vector<Vec3>& sound,
    const std::vector<Vec3>& wanted,
    const std::vector<Triangle>& faces,
    const CrossingFaces& crossing,
    const Progress& progress = {}
);

}  // namespace bspline_curve
