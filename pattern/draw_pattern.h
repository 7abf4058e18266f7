// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pattern/carried_drawing.h"
#include "pattern/pattern_layout.h"

#include <optional>

// A drawing on a surface, as all hosts ask for it.
namespace bspline_curve {

/// The drawing round a point near the surface, where the middle of its box comes to lie; see
/// PointChart for `up`. Throws what carriedDrawing() and laidRoundPoint() throw, and InputError
/// (PickTooFar) where the point is farther than kPickReachRelative from the surface.
[[nodiscard]] Pattern patternRoundPoint(
    const CurveDesigner& designer,
    const Drawing& drawing,
    const Vec3& centre,
    const std::optional<Vec3>& up,
    const DrawingScale& scale,
    const PatternOptions& options,
    const Progress& progress = {}
);

/// Copies of the drawing along a curve on the designer's surface; see CurveChart. Directions across
/// the curve are taken over a mean edge length to both sides. Throws what carriedDrawing(),
/// laidAlongCurve() and CurveChart throw.
[[nodiscard]] Pattern patternAlongCurve(
    const CurveDesigner& designer,
    const Drawing& drawing,
    const SurfacePolyline& curve,
    const RowLayout& layout,
    const PatternOptions& options,
    const Progress& progress = {}
);

}  // namespace bspline_curve
