// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/progress.h"
#include "offset/fitted_line.h"
#include "shell/extended_surface.h"
#include "surface/surface.h"

#include <cstdint>
#include <vector>

namespace bspline_curve {

enum class OffsetSides : std::uint8_t { Left, Right, Both };

struct OffsetOptions {
    double distance = 0.0;  ///< along the surface, > 0, in the user's unit
    /// Left or right of the curve, seen along it with the surface's normal upwards. Both: an open
    /// curve's offset runs round its ends.
    OffsetSides sides = OffsetSides::Both;
    /// Faces are searched in steps of this many distances, in (0, 1]: narrower gaps may be closed.
    double step = 0.1;
    /// Vertices of fitted lines and middles of their segments are at the distance to this many
    /// distances, in (0, 0.1].
    double tolerance = 5e-4;

    /// Throws InputError (BadOption).
    void validate() const;
};

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
