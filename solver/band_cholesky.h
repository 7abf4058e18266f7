// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace bspline_curve {

/// Cholesky factorisation of a symmetric positive definite matrix that is banded but for a few
/// last rows: A = L L^T, without fill outside of band and last rows. Memory and pattern are kept
/// from one matrix to the next.
class BandCholesky {
public:
    /// `size` unknowns, of which the last `border` may couple with all others; others couple with
    /// at most `bandwidth` before them.
    BandCholesky(int size, int bandwidth, int border);

    /// All entries become 0, and the factor is no more.
    void clear();

    /// Adds to the entries (row, first) to (row, last), last <= row, of the lower triangle. All
    /// must be in the band, or the row in the border.
    void addToRow(int row, int first, int last, const double* values);

    /// O(size bandwidth^2). False where the matrix is not positive definite.
    [[nodiscard]] bool factorise();

    /// Solves A x = right. O(size bandwidth).
    [[nodiscard]] Eigen::VectorXd solve(Eigen::VectorXd right) const;

private:
    /// The entries of a row of the lower triangle, so that entry (row, column) is
    /// rowOf(row)[column]; only those in the band (or in the border) exist.
    [[nodiscard]] double* rowOf(int row) {
        return entries_.data() + offsets_[static_cast<std::size_t>(row)];
    }

    [[nodiscard]] const double* rowOf(int row) const {
        return entries_.data() + offsets_[static_cast<std::size_t>(row)];
    }

    [[nodiscard]] int firstColumn(int row) const;

    int size_, bandwidth_, banded_;  // banded_: rows before the border
    std::vector<double> entries_;    // row by row
    std::vector<std::ptrdiff_t> offsets_;
    std::vector<double> inverseDiagonal_;  // of L
};

}  // namespace bspline_curve
