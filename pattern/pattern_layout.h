// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/pattern.h"
#include "pattern/drawing.h"

namespace bspline_curve {

/// The drawing in the user's unit, the middle of its box at the origin. Throws InputError
/// (BadOption), also for a drawing without paths or without size.
[[nodiscard]] Drawing laidRoundPoint(
    const Drawing& drawing, const DrawingScale& scale, double diagonal
);

/// The copies in the user's unit, from left to right: x is the length along the curve, y = 0 the
/// curve, on which the baseline or the middle of the drawing's box lies. On a closed curve a
/// spacing is changed so that it divides the length. Throws like laidRoundPoint(), and InputError
/// (BadOption) where the copies are longer than the curve.
[[nodiscard]] Drawing laidAlongCurve(
    const Drawing& drawing, const RowLayout& layout, double length, bool closed
);

}  // namespace bspline_curve
