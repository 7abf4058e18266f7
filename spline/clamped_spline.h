// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"

namespace bspline_curve {

/// The same curve with knots that are degree + 1 fold at 0 and at 1, as programs want that know no
/// periodic splines: a closed one begins and ends in one point. As many knots and control points as
/// before, but for those that repeat a corner at 0; exact to rounding. Open ones are clamped as
/// they are.
[[nodiscard]] SplineData clamped(const SplineData& spline);

}  // namespace bspline_curve
