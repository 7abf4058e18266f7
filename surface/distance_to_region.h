// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"
#include "surface/surface.h"

#include <vector>

namespace bspline_curve {

/// Distance of each vertex to a region along the surface, where it is less than `reach`; `reach`
/// where it is not. User's unit. Fast marching: exact in the plane before a straight edge, too
/// long by up to a seventh next to a corner. O(k log k), k the vertices within reach.
[[nodiscard]] std::vector<double> distancesToRegion(
    const Surface& surface, const Region& region, double reach
);

}  // namespace bspline_curve
