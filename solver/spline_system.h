// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/curve_problem.h"
#include "spline/band_cholesky.h"
#include "spline/spline_space.h"
#include "spline/symmetric_matrix.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace bspline_curve {

inline constexpr int kMaxSpanUnknowns = 3 * kMaxBasis;

/// A dense symmetric block of one span: unknown 3 j + axis is that axis of the j-th control point
/// of the span.
using SpanMatrix = Eigen::Matrix<
    double,
    Eigen::Dynamic,
    Eigen::Dynamic,
    Eigen::ColMajor,
    kMaxSpanUnknowns,
    kMaxSpanUnknowns>;
/// The same where all 3 x 3 blocks are symmetric: those of the lower triangle, block (j, k) of two
/// control points of the span, k <= j, at j (j + 1) / 2 + k.
using SpanBlocks = std::array<SymmetricMatrix, kMaxBasis*(kMaxBasis + 1) / 2>;

using SpanVector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, kMaxSpanUnknowns, 1>;

/// One row of the interpolation constraints: sum_j values[j] * control(span, j) = target.
struct InterpolationRow {
    int span = 0;
    SplineSpace::BasisValues values{};
    Vec3 target;
};

[[nodiscard]] std::vector<InterpolationRow> interpolationRows(
    const SplineSpace& space, const std::vector<PickConstraint>& picks
);

/// A factor for matrices over the control points of a spline: banded, and cyclic when closed, so
/// that the last control points border on all.
template <int kUnknowns>
[[nodiscard]] BandCholesky<kUnknowns> bandCholeskyOf(const SplineSpace& space) {
    const int controls = space.controlCount();
    return {controls, space.degree(), space.closed() ? std::min(space.degree(), controls) : 0};
}

/// Adds a dense symmetric matrix over the control points of one span, whose columns are stored
/// `stride` apart.
template <int kUnknowns>
void addSpan(
    BandCholesky<kUnknowns>& factor,
    const SplineSpace& space,
    int span,
    const double* values,
    std::ptrdiff_t stride
) {
    for (int j = 0; j < space.basisCount(); ++j) {
        const int column = space.control(span, j);
        for (int i = 0; i < space.basisCount(); ++i) {
            const int row = space.control(span, i);
            if (row >= column) {
                factor.add(row, column, values + kUnknowns * (i + j * stride), stride);
            }
        }
    }
}

/// The Newton system of a spline: a matrix over its control points, and the interpolation
/// constraints.
class SplineSystem {
public:
    SplineSystem(const SplineSpace& space, std::vector<InterpolationRow> rows);

    /// Sums span blocks into the matrix and factorises it, after adding `fitWeight` A^T A (A: the
    /// interpolation rows). False where the result is not positive definite.
    [[nodiscard]] bool factorise(const std::vector<SpanMatrix>& blocks, double fitWeight);
    [[nodiscard]] bool factorise(const std::vector<SpanBlocks>& blocks, double fitWeight);

    /// Solution of the factorised system.
    [[nodiscard]] Eigen::VectorXd solve(Eigen::VectorXd right) const {
        return factor_.solve(std::move(right));
    }

    /// The step d that minimises d^T H d / 2 + gradient^T d under A d = -residual, by the method of
    /// multipliers with the factorised H + fitWeight A^T A: two or three solves.
    [[nodiscard]] Eigen::VectorXd constrainedStep(
        const Eigen::VectorXd& gradient, const Eigen::VectorXd& residual, double fitWeight
    ) const;

    /// Moves the control points as little as possible so that the constraints hold to rounding.
    void meetConstraints(ControlPoints& controls) const;

    /// A x - target.
    [[nodiscard]] Eigen::VectorXd residual(const ControlPoints& controls) const;
    [[nodiscard]] Eigen::VectorXd applyConstraints(const Eigen::VectorXd& x) const;
    void addTransposed(const Eigen::VectorXd& multipliers, Eigen::VectorXd& out) const;

    [[nodiscard]] const std::vector<InterpolationRow>& rows() const { return rows_; }

private:
    void addBlocks(int span, const SpanBlocks& blocks);
    [[nodiscard]] bool factoriseWithRows(double fitWeight);

    const SplineSpace& space_;
    std::vector<InterpolationRow> rows_;
    BandCholesky<3> factor_;
};

}  // namespace bspline_curve
