// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/progress.h"
#include "design/near_curve.h"

#include <vector>

namespace bspline_curve {

/// A smooth curve along the line through the task's picks, nowhere farther from it than
/// the deviation (see FitOptions). Its picks are points of the curve.
///
/// The line is made smooth as a path (see fittedPath()) that the spline then follows, with as few
/// knots as that allows; where the curve comes too far from the line, the path is drawn nearer to
/// it, and again. O(n log n) for n points.
///
/// Throws InputError (NoPath, also where no curve was found so near), Cancelled.
[[nodiscard]] Curve fitLine(
    const LocatedTask& line, const FitOptions& fit, const Progress& progress
);

}  // namespace bspline_curve
