// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/options.h"
#include "bspline_curve/progress.h"
#include "design/curve_solver.h"
#include "design/near_picks.h"

#include <optional>
#include <span>
#include <vector>

namespace bspline_curve {

/// What a curve is drawn by, with picks on the surface. Refers to all of these.
struct LocatedTask {
    const PreparedSurface& prepared;
    const std::vector<SurfacePoint>& picks;
    const SolverOptions& options;
    const SamplingOptions& sampling;
    const DesignContext& context;
    WorkerThread* side = nullptr;  ///< to share work with; null: none

    [[nodiscard]] CurveSolver solver() const { return {prepared, picks, options, context, side}; }
};

struct NearCurve {
    Curve curve;
    Solved solved;
};

/// A curve that is as fair as it can be and no farther from each pick than its bound, measured from
/// the pick's point on the surface to the polyline, or as near to it as its weight asks for. The
/// leeways are in the user's unit.
///
/// A path is faired within the bounds (see fairedPath()), and the spline follows it: it passes
/// the path's points at the ends alone, or the first pick of a closed curve, and at those others
/// from which it would be too far else. Where that is no way (a region to avoid, much tension, a
/// whole shell) it passes the path's points at all picks. Nothing where there is no such path, or
/// the curve is not usable or misses a pick still: to be drawn through the picks.
///
/// Throws InputError (NoPath), Cancelled.
[[nodiscard]] std::optional<NearCurve> drawNear(
    const LocatedTask& task, std::span<const PickLeeway> leeways, const Progress& progress
);

/// Least distance of the polyline to each of some points, in its unit. O(n m).
[[nodiscard]] std::vector<double> distancesTo(
    const SurfacePolyline& line, std::span<const Vec3> points
);

}  // namespace bspline_curve
