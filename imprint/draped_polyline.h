// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/lines.h"
#include "surface/surface.h"
#include "surface/triangle_tree.h"

namespace bspline_curve {

/// A polyline that is moved along a direction onto the surface, as light would
/// throw its shadow: each of its points goes to the first face that is met on the line through it,
/// coming from outside in this direction, wherever on that line the point is. The result is strict,
/// and on the surface (not its input): its vertices are those of the polyline and where it crosses
/// edges, on the plane through segment and direction to rounding. It is looked for at steps of half
/// a mean edge; what is narrower may be missed. Where it leaves the mesh it is parted, up to the
/// boundary; where it jumps from one part of the surface to another it goes down the shortest path,
/// or is parted where there is none. Throws InputError (PickTooFar) naming the vertex where a
/// distance > 0 is given and a point is moved by more. O(n log m) for n steps and m faces.
[[nodiscard]] ProjectedLines drapedPolyline(
    const Surface& surface,
    const TriangleTree& tree,
    const SpacePolyline& line,
    const Vec3& direction,
    double distance
);

}  // namespace bspline_curve
