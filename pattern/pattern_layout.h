// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pattern/drawing.h"

namespace bspline_curve {

/// How large a drawing becomes. At most one of the two is > 0; both 0: see the functions.
struct DrawingScale {
    double size = 0.0;   ///< the longer side of the drawing's box, user's unit
    double scale = 0.0;  ///< user's units for one unit of the drawing

    /// Throws InputError (BadOption).
    void validate() const;
};

/// The size round a point if none is given, relative to the diagonal of the surface.
inline constexpr double kDrawingSizeRelative = 0.1;

/// The drawing in the user's unit, the middle of its box at the origin. Throws InputError
/// (BadOption), also for a drawing without paths or without size.
[[nodiscard]] Drawing laidRoundPoint(
    const Drawing& drawing, const DrawingScale& scale, double diagonal
);

/// Copies of a drawing along a curve.
struct RowLayout {
    DrawingScale scale;    ///< none: as large as lets the copies touch
    int repeat = 0;        ///< copies, evenly spaced; 0: as many as `spacing` says, or one
    double spacing = 0.0;  ///< from one copy to the next, user's unit; 0: as `repeat` says
    double start = 0.0;    ///< where on the curve the first copy begins, user's unit, >= 0
    double shift = 0.0;    ///< of the drawing to the left of the curve, user's unit

    /// Throws InputError (BadOption).
    void validate() const;
};

/// The copies in the user's unit, from left to right: x is the length along the curve, y = 0 the
/// curve, on which the baseline or the middle of the drawing's box lies. On a closed curve a
/// spacing is changed so that it divides the length. Throws like laidRoundPoint(), and InputError
/// (BadOption) where the copies are longer than the curve.
[[nodiscard]] Drawing laidAlongCurve(
    const Drawing& drawing, const RowLayout& layout, double length, bool closed
);

}  // namespace bspline_curve
