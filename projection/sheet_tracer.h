// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "projection/curve_distance.h"
#include "shell/extended_surface.h"
#include "spline/pick_constraint.h"
#include "surface/surface.h"

#include <limits>
#include <span>

namespace bspline_curve {

/// What a spline is followed over, and what it is near to. Refers to all of it.
struct SheetTraceStart {
    const Surface& surface;
    const ExtendedSurface& extended;
    std::span<const PickConstraint> picks;  ///< the first is where the spline starts
    double tolerance = 0.0;                 ///< of the distance, in the shell's frame
    double stepLength = 0.0;                ///< between feet, at most, in the shell's frame
    /// Points of a path beside the spline, by ascending parameter: feet are sought from there.
    /// Empty: each is sought from the one before.
    std::span<const EdgeCrossing> guide{};
    /// measureOnSheet() ends where a foot is farther; the distance is then infinite.
    double mostDistance = std::numeric_limits<double>::infinity();
};

/// Follows a spline by the nearest points of the sheet of the surface that it lies on, whatever the
/// fibres do there: over folds, through other parts of the surface, past vertices without a
/// direction. Feet are sought near to the one before, or the guide, and joined by shortest ways on
/// the surface; at the picks they are these. So the trace is whole, and its points lie strictly on
/// the surface, wherever there is a way between its feet.
///
/// The distance is that from P(t) to the point of the trace at t, measured at all of its points: it
/// is large where the spline lies near to another sheet than the picks do. About 5 us per foot.
[[nodiscard]] CurveDistance measureOnSheet(
    const SheetTraceStart& traced, const SplineSpace& space, const ControlPoints& controls
);

/// The trace along a path itself, for what no spline comes near to; the guide of `traced` must be
/// whole, and consecutive points of it must share a face.
[[nodiscard]] CurveDistance measureOnPath(
    const SheetTraceStart& traced, const SplineSpace& space, const ControlPoints& controls
);

}  // namespace bspline_curve
