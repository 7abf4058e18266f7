// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "projection/curve_distance.h"
#include "shell/extended_surface.h"
#include "spline/pick_constraint.h"

#include <optional>
#include <span>

namespace bspline_curve {

class WorkerThread;

/// What a spline is followed over: it starts at the first pick, and passes all of them. Refers to
/// what it is made from.
struct FibreTraceStart {
    const ExtendedSurface& extended;
    std::span<const PickConstraint> picks;
    double tolerance;              ///< of the distance, in the shell's frame
    WorkerThread* side = nullptr;  ///< to share work with; null: none
};

/// The foot of a spline where one of its spans starts.
struct FootOfSpan {
    int span;
    FootPoint foot;
};

/// Follows the foot of a spline over the extended surface, along the fibres, from the first pick
/// on: it needs no shell, and takes less time than a trace through the cells of one. Exact to 1e-11
/// of a face. The distance is |P - q| at the start and the middle of each piece; beyond a boundary
/// that to the boundary. It is infinite from where the fibres cross between the curve and the
/// surface, or the base ends; and on spans that pass a pick elsewhere than on the surface, as on
/// the wrong side of a thin plate. O(n) for n faces passed, about 0.5 us each. `middle`: a foot
/// from which the rest is followed at the same time; of no use where the way from the first pick
/// leads elsewhere.
[[nodiscard]] CurveDistance measureAlongFibres(
    const FibreTraceStart& traced,
    const SplineSpace& space,
    const ControlPoints& controls,
    const std::optional<FootOfSpan>& middle = {}
);

/// The foot of the spline at t in [0, 1], on the face that the trace has there.
[[nodiscard]] FootPoint footAt(
    const ExtendedSurface& extended,
    const FibreTrace& trace,
    const SplineSpace& space,
    const ControlPoints& controls,
    double t
);

}  // namespace bspline_curve
