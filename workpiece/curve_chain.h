// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/progress.h"
#include "bspline_curve/workpiece.h"

#include <optional>
#include <span>
#include <vector>

// Open curves one after the other.
namespace bspline_curve {

/// Where an open curve begins or ends.
struct CurveEnd {
    Vec3 onMesh;     ///< of the polyline
    Vec3 ofSpline;   ///< near it
    Vec3 direction;  ///< of the spline there, along the curve, unit length
};

[[nodiscard]] CurveEnd startOf(const Curve& curve);
[[nodiscard]] CurveEnd endOf(const Curve& curve);

/// How a curve is to meet those before and after it.
struct DrawnBetween {
    std::vector<Vec3> picks;  ///< on the mesh
    int degree = 3;           ///< 1: the polyline is its spline
    /// Where its spline begins and ends, and in which directions, to rounding; none: as it is
    /// drawn.
    std::optional<CurveEnd> from, to;
    Vec3 first = Vec3::Zero(), last = Vec3::Zero();  ///< directions that are asked for; zero: any
};

/// The fairest curve through some picks. Throws InputError, Cancelled.
[[nodiscard]] Curve drawnBetween(
    const Workpiece& workpiece, const DrawnBetween& asked, const Progress& progress
);

/// Curves of one degree as one: each begins where the one before ends. Parameters are shared by
/// length; where two curves meet there are knots whose multiplicity is the degree, and `isSmooth`
/// says of each such place that no corner is meant, so that no pick is there. O(n).
[[nodiscard]] Curve chained(std::span<const Curve> curves, bool isSmooth);

}  // namespace bspline_curve
