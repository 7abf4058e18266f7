// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/sketch.h"

#include <QString>

namespace bspline_curve {

/// "1 curve", "2 curves".
[[nodiscard]] QString countText(int count, const QString& noun);

/// What people want to know of a curve: how many picks, how long, how near to the surface, or why
/// there is none. `edge`: the mean edge length of the surface; `unit`: of lengths, or empty.
[[nodiscard]] QString wordsFor(const SketchCurve& curve, double edge, const QString& unit);

/// How a curve passes a pick, where that is not as usual; else empty. -1: no pick.
[[nodiscard]] QString wordsForKind(const SketchCurve& curve, int pick);

}  // namespace bspline_curve
