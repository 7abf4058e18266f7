// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "filters/figures.h"
#include "filters/workpiece_cache.h"

namespace bspline_curve {

/// The shell that a curve was drawn in, as reports say it: "fibres", "full" or "simplified".
[[nodiscard]] const char* shellName(const Curve& curve);

/// How long one curve took on a surface that was ready.
[[nodiscard]] double secondsOf(const SolveReport& report);

/// What the filter for curves answers with; lengths and control points in world units. `seconds`:
/// of the whole run. Times of what was kept from an earlier curve are 0.
[[nodiscard]] Figures curveFigures(
    const Curve& curve, const WorkpieceCache::Found& found, double seconds
);

}  // namespace bspline_curve
