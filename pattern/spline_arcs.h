// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

#include <vector>

namespace bspline_curve {

/// A part of a path in space: a Bézier curve of any degree, rational where it has weights.
struct SpaceArc {
    std::vector<Vec3> points;     ///< control points, at least 2
    std::vector<double> weights;  ///< one for each, > 0; empty: all are 1

    /// The point at a parameter in [0, 1].
    [[nodiscard]] Vec3 at(double t) const;
};

/// A B-spline, rational where it has weights.
struct SpaceSpline {
    int degree = 3;             ///< >= 1
    std::vector<double> knots;  ///< ascending; as many as control points, plus degree + 1
    std::vector<Vec3> points;
    std::vector<double> weights;  ///< one for each point, > 0; empty: all are 1
};

/// The spline's pieces between its knots, as arcs that are the same curve. Throws
/// std::invalid_argument where the numbers do not fit each other.
[[nodiscard]] std::vector<SpaceArc> arcsOf(const SpaceSpline& spline);

/// The cubic spline through points, twice continuously differentiable, whose parameter is the
/// length of the chords: one arc between two points. Directions at the ends may be zero: the
/// curvature is 0 there. Equal neighbours are one point. `closed`: it ends in its first point as
/// smoothly as it passes all others. Empty where less than two points are apart. O(n).
[[nodiscard]] std::vector<SpaceArc> arcsThrough(
    std::vector<Vec3> points, const Vec3& startDirection, const Vec3& endDirection, bool closed
);

/// Points of arcs that follow each other, so dense that chords are within a distance of them; each
/// end is one, and the start of the first.
[[nodiscard]] std::vector<Vec3> flattened(const std::vector<SpaceArc>& arcs, double distance);

}  // namespace bspline_curve
