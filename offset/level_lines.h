// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/progress.h"
#include "offset/distance_beams.h"

#include <vector>

namespace bspline_curve {

/// A line of points at one distance from a curve. The curve lies to its right, seen with the
/// surface's normal upwards.
struct LevelLine {
    bool closed = false;               ///< the first point is not repeated
    std::vector<SurfacePoint> points;  ///< consecutive ones share a face
    std::vector<CurveSide> sides;      ///< of each point
};

/// All lines at `distance` from a curve. They never cross themselves or each other, since they
/// bound the faces' part that is nearer; where two parts of an offset run into each other, they
/// end. Faces are divided into rows at most `distance` times `stepRelative` high; what is narrower
/// can be missed. Time grows with the rows that a line passes, and not with the faces' areas.
/// Vertices are at the distance to 1e-12 of it, the middles of segments to 2e-4, but
/// where a corner of a line is narrower than a face's division. `beams` must hold `distance` in its
/// range. Throws Cancelled.
[[nodiscard]] std::vector<LevelLine> levelLines(
    const Surface& surface,
    const DistanceBeams& beams,
    double distance,
    double stepRelative,
    const Progress& progress = {}
);

}  // namespace bspline_curve
