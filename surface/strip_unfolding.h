// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/surface.h"

#include <vector>

namespace bspline_curve {

/// The shortest path inside a strip of faces, from a point of its first face to one of its last.
struct StripPath {
    struct Corner {
        /// The path bends at an end of the edge between faces portal and portal + 1.
        std::size_t portal;
        int vertex;
        double bend;  ///< turning angle there, radians, > 0
    };

    /// For each edge between consecutive faces of the strip, where the path crosses it: 0 at its
    /// left end, 1 at its right.
    std::vector<double> crossings;
    std::vector<int> lefts, rights;  ///< vertices at the ends of these edges, seen along the strip
    std::vector<Corner> corners;
};

/// Unfolds the strip into the plane and pulls the path tight (funnel algorithm). Consecutive faces
/// share an edge. Linear time up to repeated restarts of the funnel.
[[nodiscard]] StripPath shortestPathInStrip(
    const Surface& surface,
    const std::vector<int>& strip,
    const SurfacePoint& start,
    const SurfacePoint& goal
);

}  // namespace bspline_curve
