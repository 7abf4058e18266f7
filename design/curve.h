// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/shell_options.h"
#include "solver/solve_report.h"
#include "surface/types.h"

#include <optional>
#include <span>
#include <vector>

namespace bspline_curve {

/// The spline as people keep it: degree, full knot vector, control points in the user's unit.
struct SplineData {
    int degree = 3;
    bool closed = false;
    /// Open: clamped on [0, 1], controlPoints + degree + 1 knots. Closed: periodic with period 1,
    /// the knots of the unclamped form whose first `degree` control points are repeated at the end
    /// (the form that OBJ and IGES use).
    std::vector<double> knots;
    std::vector<Vec3> controlPoints;     ///< closed: with the repeated ones
    std::vector<double> pickParameters;  ///< t of each pick, ascending, in [0, 1]
};

/// A polyline strictly on the surface: every vertex in a face, every segment inside one face. A
/// closed one does not repeat its first vertex at the end.
struct SurfacePolyline {
    bool closed = false;
    std::vector<SurfacePoint> surfacePoints;
    std::vector<Vec3> points;        ///< positions of surfacePoints, in the user's unit
    std::vector<double> parameters;  ///< t of the spline, ascending
    std::vector<int> picks;          ///< index of each pick's vertex
};

/// How finely the polyline follows the spline. The crossings of mesh edges and the picks are always
/// vertices.
struct SamplingOptions {
    int samples = 256;  ///< at least this many evenly spaced parameters as well; 0: none asked
    double maxSegmentLength = 0.0;  ///< no segment longer than this, user's unit; 0: not limited

    /// Throws InputError (BadOption).
    void validate() const;
};

struct Curve {
    SurfacePolyline polyline;
    SplineData spline;
    SolveReport report;
    /// The shell that the curve was drawn in; none: it was drawn along fibres, without one.
    std::optional<ShellKind> shell;
    int prisms = 0;       ///< of that shell, without blocked ones; 0 without a shell
    int facesPassed = 0;  ///< different faces that the curve passes, along fibres; else 0
};

/// What a curve is drawn by, besides its picks. All may be empty.
struct CurveInputs {
    std::span<const double> field{};  ///< one finite value per vertex
    std::span<const int> avoid{};     ///< faces that the curve must not enter
    /// A curve of the same designer through as many picks, each near the one of now, as while a
    /// pick is dragged: the new curve is relaxed from that one, displaced with its picks (see
    /// dragCurve), in six tenths of the time on average, and bends as much as one from scratch.
    /// No start where degree or closedness differ, where it was not relaxed at foot points, or
    /// where a piece between picks would double or halve its length.
    const Curve* start = nullptr;
};

}  // namespace bspline_curve
