// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"
#include "projection/fibre_projector.h"

#include <variant>
#include <vector>

namespace bspline_curve {

/// Where the shadow of a curve passes from one face into the next.
struct EdgeCrossing {
    double parameter;
    SurfacePoint point;  ///< on the edge that is crossed
};

/// A point over a face of the extended surface, by its barycentric coordinates there, as one of the
/// surface: ghosts collapse onto the boundary edge that they grew from. Clears rounding.
[[nodiscard]] SurfacePoint onSurface(
    const ExtendedSurface& extended, int face, const Vec3& barycentric
);

/// What every trace of a spline tells, along it.
struct TraceProgress {
    bool isWhole = false;  ///< else the trace ends where the spline leaves what it is traced in
    int wholeSpans = 0;    ///< traced to their end
    std::vector<EdgeCrossing> crossings;
};

/// The cells of a shell that a spline passes, in order.
struct CellTrace : TraceProgress {
    struct Piece {
        double end;  ///< parameter
        int span;
        int tet, foot, face;
    };

    std::vector<Piece> pieces;
};

/// The faces under a spline along the fibres (see FootPoint), in order.
struct FibreTrace : TraceProgress {
    struct Piece {
        double end;  ///< parameter
        int span;
        FootPoint foot;  ///< of a point of the piece
    };

    std::vector<Piece> pieces;
};

/// Points of the surface beside a spline, from its start to its end, each in one face with the one
/// before (see measureOnSheet()).
struct SheetTrace : TraceProgress {
    struct Piece {
        double end;  ///< parameter
        int span;
        int face;
    };

    std::vector<EdgeCrossing> points;
    std::vector<Piece> pieces;  ///< the i-th from the i-th point to the next
};

/// A trace holds for one spline, and for one shell, base or surface.
using CurveTrace = std::variant<CellTrace, FibreTrace, SheetTrace>;

/// What both have.
[[nodiscard]] const TraceProgress& progressOf(const CurveTrace& trace);

/// The face of the extended surface at a parameter in [0, 1]. O(log n).
[[nodiscard]] int faceAt(const CurveTrace& trace, double t);

/// The faces passed, ghosts included; one may come several times.
[[nodiscard]] std::vector<int> facesPassed(const CurveTrace& trace);

}  // namespace bspline_curve
