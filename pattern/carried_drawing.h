// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/pattern.h"
#include "bspline_curve/progress.h"
#include "design/curve_designer.h"
#include "pattern/drawing.h"
#include "pattern/surface_chart.h"

#include <vector>

namespace bspline_curve {

/// Draws every path of a drawing (in the unit of the surface) as curves on the surface, through
/// picks that the chart carries there: one curve for each part without a corner, closed where the
/// path is closed and has none. Curves that meet in a corner end in the same point. Curves get more
/// picks until all points of the drawing are within the tolerance. Throws InputError (NoPath) where
/// a path cannot be carried, or is smaller than what picks on the surface can tell apart; it names
/// the path by its number and elements() are the numbers of all such paths; (BadOption) for a
/// drawing without paths; Cancelled.
[[nodiscard]] Pattern carriedDrawing(
    const CurveDesigner& designer,
    const SurfaceChart& chart,
    const Drawing& drawing,
    const PatternOptions& options,
    const Progress& progress = {}
);

}  // namespace bspline_curve
