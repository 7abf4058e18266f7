// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/progress.h"
#include "design/near_curve.h"

#include <vector>

namespace bspline_curve {

/// A smooth curve along the line through the task's picks, nowhere farther from it than
/// `deviation` (user's unit, > 0; see FitOptions). Its picks are points of the curve.
///
/// The line is made smooth as a path (see fittedPath()) that the spline then follows; where the
/// curve comes too far from the line, the path is drawn nearer to it, and again. `isNoiseKnown`:
/// the line may be as far off as the deviation says; else waves of more than twelve of its points
/// are taken for meant.
///
/// Throws InputError (NoPath, also where no curve was found so near), Cancelled.
[[nodiscard]] NearCurve fitLine(
    const LocatedTask& line, double deviation, bool isNoiseKnown, const Progress& progress
);

}  // namespace bspline_curve
