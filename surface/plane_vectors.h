// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace bspline_curve {

/// The third component of the cross product of two vectors of a plane: twice the signed area of
/// their triangle, positive where b is on the left of a.
[[nodiscard]] inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

}  // namespace bspline_curve
