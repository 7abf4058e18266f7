// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "offset/distance_beams.h"

#include <vector>

namespace bspline_curve {

/// Beams that leave a polyline: from each segment at right angles to both sides, from each vertex
/// into the angles that no segment's beams cover. Each covers a part of the face that it starts in.
[[nodiscard]] std::vector<DistanceBeam> beamsOfPolyline(
    const Surface& surface, const SurfacePolyline& line
);

/// Beams that leave a vertex in all directions.
[[nodiscard]] std::vector<DistanceBeam> beamsOfVertex(
    const Surface& surface, int vertex, const SidedDistance& distance
);

}  // namespace bspline_curve
