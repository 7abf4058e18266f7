// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <algorithm>

namespace bspline_curve {

/// The share of a segment, which may have no length, at which it is nearest to a point.
template <int Dimension>
[[nodiscard]] double nearestShare(
    const Eigen::Matrix<double, Dimension, 1>& point,
    const Eigen::Matrix<double, Dimension, 1>& from,
    const Eigen::Matrix<double, Dimension, 1>& to
) {
    const Eigen::Matrix<double, Dimension, 1> along = to - from;
    const double squared = along.squaredNorm();
    return squared > 0.0 ? std::clamp((point - from).dot(along) / squared, 0.0, 1.0) : 0.0;
}

/// Distance of a point to a segment, which may have no length, in any dimension.
template <int Dimension>
[[nodiscard]] double distanceToSegment(
    const Eigen::Matrix<double, Dimension, 1>& point,
    const Eigen::Matrix<double, Dimension, 1>& from,
    const Eigen::Matrix<double, Dimension, 1>& to
) {
    return (point - from - nearestShare(point, from, to) * (to - from)).norm();
}

}  // namespace bspline_curve
