// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/offset.h"
#include "bspline_curve/progress.h"
#include "offset/distance_beams.h"
#include "offset/fitted_line.h"
#include "shell/extended_surface.h"
#include "surface/surface.h"

#include <cstdint>
#include <vector>

namespace bspline_curve {

/// The lines at a geodesic distance from a polyline. Both are on the surface's input. See
/// DistanceBeams and LevelLine for their accuracy. Where an offset runs into itself or another
/// part, both end, so that no piece crosses itself or another; where two parts of it meet in a
/// corner it is cut there, see cutAtCorners(). Lines end at the surface's boundary. Longest piece
/// first. t is the length along the piece, from 0 to 1. Empty where no point has that distance.
/// Throws InputError (BadOption; NoPath where `line` is not strict or has no length) or Cancelled.
[[nodiscard]] std::vector<SurfacePolyline> offsetPolylines(
    const Surface& surface,
    const SurfacePolyline& line,
    const OffsetOptions& options,
    const Progress& progress = {}
);

/// All lines at a distance that `beams` has in its range, whole, with the surface's own faces.
/// `step`: see OffsetOptions. Throws Cancelled.
[[nodiscard]] std::vector<SurfacePolyline> wholeLinesAt(
    const Surface& surface,
    const DistanceBeams& beams,
    double distance,
    double step,
    const Progress& progress = {}
);

/// These lines as our curves: each fitted by a cubic spline that is projected onto the surface, see
/// LineFitter. Fitted lines neither cross themselves nor each other: where they would, they are
/// fitted more closely, and the line itself is taken in the end. `extended`: of the surface. Throws
/// like offsetPolylines().
[[nodiscard]] std::vector<FittedLine> offsetCurves(
    const Surface& surface,
    const ExtendedSurface& extended,
    const SurfacePolyline& line,
    const OffsetOptions& options,
    const Progress& progress = {}
);

/// For each face of the input whether its middle is within `distance` of the polyline on the
/// surface, on one side or both. Throws like offsetPolylines().
[[nodiscard]] std::vector<char> facesWithin(
    const Surface& surface,
    const SurfacePolyline& line,
    const OffsetOptions& options,
    const Progress& progress = {}
);

}  // namespace bspline_curve
