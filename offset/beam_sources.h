// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "offset/distance_beams.h"

#include <vector>

namespace bspline_curve {

/// Beams that leave a polyline: from each segment at right angles to both sides, from each vertex
/// into the angles that no segment's beams cover: into all where it has no segment. Each covers a
/// part of the face that it starts in.
[[nodiscard]] std::vector<DistanceBeam> beamsOfPolyline(
    const Surface& surface, const SurfacePolyline& line
);

/// How a way comes to a vertex.
struct VertexArrival {
    int face = -1;       ///< over which; -1: not known
    double angle = 0.0;  ///< back along the way, counter-clockwise from the side to the next corner
};

/// Beams that leave a vertex in all directions in which a shortest way that came there may go on:
/// at least half a turn of the surface from where it came, to both sides.
[[nodiscard]] std::vector<DistanceBeam> beamsOfVertex(
    const Surface& surface, int vertex, const SidedDistance& distance, const VertexArrival& arrival
);

}  // namespace bspline_curve
