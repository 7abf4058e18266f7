// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "support/random.h"
#include "surface/surface.h"

#include <array>
#include <vector>

namespace bspline_curve::test_support {

/// A polyline through given places, its t evenly spaced.
SurfacePolyline polylineThrough(
    const Surface& surface, const std::vector<SurfacePoint>& points, bool closed
);

/// A polyline along edges, through given vertices.
SurfacePolyline polylineAlong(
    const Surface& surface, const std::vector<int>& vertices, bool closed
);

/// The same on a plate of n x n cells, through grid points (i, j).
SurfacePolyline alongGrid(
    const Surface& surface, int n, const std::vector<std::array<int, 2>>& grid, bool closed
);

/// A random strict polyline: an open walk over faces, edges and vertices, which turns back, crosses
/// itself and runs along edges; or a closed one in one face, or round a vertex.
SurfacePolyline randomCurve(const Surface& surface, Random& random);

/// One to eight of them, most near each other.
std::vector<SurfacePolyline> randomCurves(const Surface& surface, Random& random);

}  // namespace bspline_curve::test_support
