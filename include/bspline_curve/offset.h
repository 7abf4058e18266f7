// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/progress.h"
#include "bspline_curve/workpiece.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace bspline_curve {

/// Seen along a curve with the surface's normal upwards.
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

/// A line at a distance as one of our curves.
struct FittedLine {
    SurfacePolyline line;    ///< the spline's projection, strictly on the surface
    SplineData spline;       ///< of degree 3, or 1 where isFitted is false
    double deviation = 0.0;  ///< largest of vertices and middles of segments, in distances
    bool isFitted = false;   ///< else no spline came near enough: the line itself
};

/// Lines beside some lines.
struct OffsetLines {
    struct Piece {
        FittedLine line;
        int curve = 0;  ///< which of the lines it is beside
    };

    std::vector<Piece> pieces;  ///< of each curve the longest first
    std::vector<char> band;     ///< per face, within the distance; only where it is asked for

    /// Whether a piece is beside a line.
    [[nodiscard]] bool hasBeside(std::size_t line) const;
};

/// What to say where none is.
inline constexpr const char* kNothingBeside =
    "no point of the surface on that side is at this distance from the curve; give a smaller "
    "offset";

/// Lines at a geodesic distance from each of some lines, as curves: each fitted by a cubic spline
/// that is projected onto the surface. They end at the surface's boundary, and neither cross
/// themselves nor each other. None where no point of the surface has that distance. `withBand`: the
/// faces within are found as well. O(k log k) for k vertices within reach. Throws InputError
/// (BadOption; NoPath where a line is not strict or has no length), Cancelled.
[[nodiscard]] OffsetLines linesBeside(
    const Workpiece& workpiece,
    std::span<const SurfacePolyline> lines,
    const OffsetOptions& options,
    bool withBand = false,
    const Progress& progress = {}
);

/// For each face whether its middle is within the distance of a line, on one side or both. Throws
/// likewise.
[[nodiscard]] std::vector<char> facesWithin(
    const Workpiece& workpiece,
    const SurfacePolyline& line,
    const OffsetOptions& options,
    const Progress& progress = {}
);

}  // namespace bspline_curve
