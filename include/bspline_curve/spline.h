// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/tangent.h"

#include <utility>
#include <vector>

// All functions here expect a spline as SplineData says: knots that ascend, degree + 1 more of them
// than control points. They read it alone, so that any number of threads may call them.
namespace bspline_curve {

/// The point at a parameter; t in [0, 1]. O(degree^2 + log n) for n knots.
[[nodiscard]] Vec3 positionOf(const SplineData& spline, double t);

/// The derivative of some order by t, at a knot that from the right, but at t = 1 of an open spline
/// from the left; t in [0, 1], order >= 1. User's unit. O(n).
[[nodiscard]] Vec3 derivativeOf(const SplineData& spline, double t, int order = 1);

/// The curvature vector, of length 1 / radius, towards the centre; one over the user's unit. Zero
/// where the curve stands still. O(n).
[[nodiscard]] Vec3 curvatureOf(const SplineData& spline, double t);

/// A piece of a spline as a Bézier curve over [from, to].
struct BezierPiece {
    double from = 0.0, to = 1.0;
    std::vector<Vec3> controlPoints;  ///< degree + 1
};

/// The spline as Bézier curves from t = 0 to t = 1, one for each span between knots. Exact to
/// rounding. O(n).
[[nodiscard]] std::vector<BezierPiece> bezierPieces(const SplineData& spline);

/// The same curve with knots that are degree + 1 fold at 0 and at 1, as programs want that know no
/// periodic splines: a closed one begins and ends in one point. As many knots and control points as
/// before, but for those that repeat a corner at 0; exact to rounding. Open ones are clamped as
/// they are.
[[nodiscard]] SplineData clamped(const SplineData& spline);

/// The same curve from its end to its start: what was at t is at 1 - t. Exact to rounding. O(n).
[[nodiscard]] SplineData reversedSpline(const SplineData& spline);

/// The part between two parameters as an open spline over [0, 1]; of a closed one `to` may be more
/// than 1, from < to <= from + 1. Without parameters of picks. Exact to rounding. O(n).
[[nodiscard]] SplineData partOfSpline(const SplineData& spline, double from, double to);

/// Picks that are corners, by the knots at their parameters; ascending.
[[nodiscard]] std::vector<int> cornersOf(const SplineData& spline);

/// The directions in which a spline comes to a pick and goes on, of unit length: at a corner two,
/// elsewhere the same. O(n).
[[nodiscard]] PickTangent directionsAtPick(const SplineData& spline, int pick);

/// Of the picks at which the curve was asked to have a direction (SolveReport::tangents), that of
/// its spline, of unit length.
[[nodiscard]] std::vector<std::pair<int, PickTangent>> tangentsAtPicks(const Curve& curve);

/// The polyline as a spline of degree 1: its vertices are the control points, its t the knots.
[[nodiscard]] SplineData polygonSpline(const SurfacePolyline& line);

}  // namespace bspline_curve
