// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/designer.h"
#include "bspline_curve/progress.h"
#include "pattern/drawing.h"
#include "pattern/surface_chart.h"

#include <vector>

namespace bspline_curve {

struct PatternOptions {
    double cornerAngle = 20.0;  ///< degrees, in (0, 179]: paths that turn more have a corner there
    /// How far a curve may be from the carried drawing, user's unit; 0: kPatternToleranceRelative.
    double tolerance = 0.0;

    /// Passes of smoothedRelief() over a copy of the surface on which the ways of the drawing are
    /// found, in [0, 1000]: on rough scans the drawing comes out more evenly.
    int smoothing = 0;

    /// Throws InputError (BadOption).
    void validate() const;
};

/// The tolerance if none is given, in the mean diagonal of the boxes of paths.
inline constexpr double kPatternToleranceRelative = 1e-3;

/// A smooth piece of a path of a drawing, as a curve on the surface.
struct PatternCurve {
    Curve curve;
    int path = 0;  ///< DrawingPath::number
    int copy = 0;  ///< DrawingPath::copy
};

/// The length of a part of a curve, between two picks, relative to what was drawn.
struct Distortion {
    double ratio = 1.0;
    int path = 0, copy = 0;  ///< of the drawing
    Vec3 position = Vec3::Zero();
};

struct Pattern {
    std::vector<PatternCurve> curves;  ///< in the order of the paths, and along them
    double tolerance = 0.0;
    /// Largest distance of a carried point to its curve, user's unit. More than the tolerance only
    /// where the surface's faces bend the drawing within an edge's length.
    double largestDeviation = 0.0;
    Distortion shortest, longest;
};

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
