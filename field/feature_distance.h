// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/surface.h"

#include <vector>

namespace bspline_curve {

/// Vertices of edges whose two faces turn by more than the angle, ascending. O(n).
[[nodiscard]] std::vector<int> creaseVertices(const Surface& surface, double angleDegrees);

/// Vertices of edges with one face, ascending. O(n).
[[nodiscard]] std::vector<int> boundaryVertices(const Surface& surface);

/// Geodesic distances of the vertices to the nearest source, #V, in the unit of the surface;
/// infinite beyond `reach` and where no source is. By fast marching over the faces: exact for
/// straight rows of sources on flat parts, else of first order in the edge length, and longer than
/// exact by a few per cent where faces are obtuse. O(n log n) for n vertices within reach.
[[nodiscard]] std::vector<double> distancesTo(
    const Surface& surface, const std::vector<int>& sources, double reach
);

}  // namespace bspline_curve
