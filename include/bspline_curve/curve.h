// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"
#include "bspline_curve/report.h"
#include "bspline_curve/shell.h"

#include <optional>
#include <vector>

namespace bspline_curve {

/// The spline as people keep it: degree, full knot vector, control points in the user's unit.
struct SplineData {
    int degree = 3;
    bool closed = false;
    /// Open: clamped on [0, 1], controlPoints + degree + 1 knots. Closed: periodic with period 1,
    /// the knots of the unclamped form whose first `degree` control points are repeated at the end
    /// (the form that OBJ and IGES use). Inner knots are simple, but for those of corners, whose
    /// multiplicity is the degree; the first of those at t = 0 is knots[degree].
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

/// The length of a polyline in the user's unit, with the segment that closes it.
[[nodiscard]] double lengthOf(const SurfacePolyline& line);

/// A curve that was drawn.
struct Curve {
    SurfacePolyline polyline;
    /// The picks, as points of the surface, where the curve need not pass them; else empty: they
    /// are vertices of the polyline.
    std::vector<SurfacePoint> nearPicks{};
    std::vector<Vec3> nearPickPositions{};  ///< of these, in the user's unit
    SplineData spline;
    SolveReport report;
    /// The shell that the curve was drawn in; none: it was drawn along fibres, without one.
    std::optional<ShellKind> shell;
    int prisms = 0;       ///< of that shell, without blocked ones; 0 without a shell
    int facesPassed = 0;  ///< different faces that the curve passes, along fibres; else 0
};

}  // namespace bspline_curve
