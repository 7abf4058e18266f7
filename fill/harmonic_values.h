// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

#include <Eigen/Core>

#include <vector>

namespace bspline_curve {

/// A row for each point.
using ValueRows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic>;

/// Harmonic values on a patch: those of its first points, the rim, stay; each other one is a mean
/// of its neighbours, weighted by cotangents, none of them negative, so that no value is outside
/// the range of the rim. `values`: a row for each point of the rim. Returns one for each point. One
/// sparse factorisation, O(n^1.5).
[[nodiscard]] ValueRows harmonicFrom(
    const std::vector<Vec3>& points, const std::vector<Triangle>& faces, const ValueRows& values
);

}  // namespace bspline_curve
