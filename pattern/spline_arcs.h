// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pattern/drawing.h"

#include <vector>

namespace bspline_curve {

/// A planar B-spline, rational where it has weights.
struct PlanarSpline {
    int degree = 3;             ///< >= 1
    std::vector<double> knots;  ///< ascending; as many as control points, plus degree + 1
    std::vector<Eigen::Vector2d> points;
    std::vector<double> weights;  ///< one for each point, > 0; empty: all are 1
};

/// The spline's pieces between its knots, as arcs that are the same curve. Throws
/// std::invalid_argument where the numbers do not fit each other.
[[nodiscard]] std::vector<DrawingArc> arcsOf(const PlanarSpline& spline);

}  // namespace bspline_curve
