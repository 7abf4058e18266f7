// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/lines.h"
#include "surface/surface.h"
#include "surface/triangle_tree.h"

#include <vector>

namespace bspline_curve {

/// Follows the name of what was to be draped.
inline constexpr const char* kNothingMet =
    ": nothing of it meets the mesh along the direction; move it, or give another direction";

/// A polyline that is near the surface, projected onto it: its points become their closest points,
/// and so do points between them, as dense as edges are there; shortest paths join these. The
/// result is strict, and on the surface's input; t is the length along it, from 0 to 1. Throws
/// InputError (PickTooFar) where a point of the polyline is farther from the surface than
/// `distance`, and (NoPath) where one part of it and the next are near to parts of the surface that
/// are not, or where nothing but one point is left; both name the vertex. The message begins with
/// it, so that callers can say of which polyline. O(n log m) for n points of the result and m
/// faces.
[[nodiscard]] SurfacePolyline projectedPolyline(
    const Surface& surface, const TriangleTree& tree, const SpacePolyline& line, double distance
);

/// The same, or along the direction of the options, see drapedPolyline(); on the surface's input.
/// Throws likewise.
[[nodiscard]] ProjectedLines projectedLines(
    const Surface& surface,
    const TriangleTree& tree,
    const SpacePolyline& line,
    const ProjectionOptions& options
);

/// Gives the vertices of a line the lengths up to them as t, from 0 to 1.
void setParametersByLength(SurfacePolyline& line);

}  // namespace bspline_curve
