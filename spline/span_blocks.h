// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spline/spline_space.h"
#include "spline/symmetric_matrix.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>

namespace bspline_curve {

/// A symmetric matrix over the control points of one span whose 3 x 3 blocks are symmetric as well:
/// those of the lower triangle, block (j, k) of two control points of the span, k <= j, at
/// blockIndex(j, k).
using SpanBlocks = std::array<SymmetricMatrix, kMaxBasis*(kMaxBasis + 1) / 2>;

[[nodiscard]] constexpr std::size_t blockIndex(int j, int k) {
    return j * (j + 1) / 2 + k;
}

inline constexpr int kMaxSpanUnknowns = 3 * kMaxBasis;

/// The same as a dense matrix: unknown 3 j + axis is that axis of the j-th control point.
using SpanMatrix = Eigen::Matrix<
    double,
    Eigen::Dynamic,
    Eigen::Dynamic,
    Eigen::ColMajor,
    kMaxSpanUnknowns,
    kMaxSpanUnknowns>;
using SpanVector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, kMaxSpanUnknowns, 1>;

[[nodiscard]] inline Eigen::Matrix3d dense(const SymmetricMatrix& m) {
    Eigen::Matrix3d result;
    result << m[0], m[1], m[2], m[1], m[3], m[4], m[2], m[4], m[5];
    return result;
}

[[nodiscard]] inline SpanMatrix dense(const SpanBlocks& blocks, int basisCount) {
    SpanMatrix result(3 * basisCount, 3 * basisCount);
    for (int j = 0; j < basisCount; ++j) {
        for (int k = 0; k <= j; ++k) {
            result.block<3, 3>(3 * j, 3 * k) = dense(blocks[blockIndex(j, k)]);
            result.block<3, 3>(3 * k, 3 * j) = result.block<3, 3>(3 * j, 3 * k);
        }
    }
    return result;
}

/// The control points of one span.
using SpanControls = std::array<Vec3, kMaxBasis>;

[[nodiscard]] inline SpanControls controlsOf(
    const SplineSpace& space, const ControlPoints& controls, int span
) {
    SpanControls result;
    for (int j = 0; j < space.basisCount(); ++j) {
        const double* const row = controls.data() + 3 * std::ptrdiff_t{space.control(span, j)};
        result[j] = {row[0], row[1], row[2]};
    }
    return result;
}

/// The unknowns of one span, of a vector over all control points.
[[nodiscard]] inline SpanVector unknownsOf(
    const SplineSpace& space, int span, const Eigen::VectorXd& all
) {
    SpanVector result(3 * space.basisCount());
    for (int j = 0; j < space.basisCount(); ++j) {
        result.segment<3>(3 * j) = all.segment<3>(3 * space.control(span, j));
    }
    return result;
}

}  // namespace bspline_curve
