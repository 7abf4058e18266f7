// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <algorithm>

namespace bspline_curve {

/// Distance of a point to a segment, which may have no length, in any dimension.
template <int Dimension>
[[nodiscard]] double distanceToSegment(
    const Eigen::Matrix<double, Dimension, 1>& point,
    const Eigen::Matrix<double, Dimension, 1>& from,
    const Eigen::Matrix<double, Dimension, 1>& to
) {
    const Eigen::Matrix<double, Dimension, 1> along = to - from;
    const double squared = along.squaredNorm();
    const double share =
        squared > 0.0 ? std::clamp((point - from).dot(along) / squared, 0.0, 1.0) : 0.0;
    return (point - from - share * along).norm();
}

}  // namespace bspline_curve
