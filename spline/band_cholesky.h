// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spline/symmetric_matrix.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace bspline_curve {

/// Cholesky factorisation of a symmetric positive definite matrix of square blocks of so many
/// unknowns, one row of them per control point, that is banded but for a few last rows: A = L L^T,
/// without fill outside of band and last rows. Memory and pattern are kept from one matrix to the
/// next. Made for 1 and 3 unknowns.
template <int kUnknowns>
class BandCholesky {
public:
    /// `points` rows of blocks, of which the last `border` may couple with all others; others
    /// couple with at most `bandwidth` before them.
    BandCholesky(int points, int bandwidth, int border);

    /// All entries become 0, and the factor is no more.
    void clear();

    /// Adds to the block (row, column), column <= row, in the band or the border. `values` is its
    /// first entry in a matrix that is stored by columns `stride` apart.
    void add(int row, int column, const double* values, std::ptrdiff_t stride);

    /// The same for a symmetric block.
    void addSymmetric(int row, int column, const SymmetricMatrix& m)
        requires(kUnknowns == 3)
    {
        Block& block = rowOf(row)[column];
        block[0] += m[0];
        block[1] += m[1];
        block[2] += m[2];
        block[3] += m[1];
        block[4] += m[3];
        block[5] += m[4];
        block[6] += m[2];
        block[7] += m[4];
        block[8] += m[5];
    }

    /// O(points bandwidth^2). False where the matrix is not positive definite.
    [[nodiscard]] bool factorise();

    /// Solves A x = right. O(points bandwidth).
    [[nodiscard]] Eigen::VectorXd solve(Eigen::VectorXd right) const;

    /// The same in place for rows first to last, none of them of the border, where `right` is 0
    /// before first and unknowns behind last are held at 0. Others are left alone. O((last - first)
    /// bandwidth).
    void solveBetween(int first, int last, Eigen::VectorXd& right) const;

private:
    static constexpr auto kSize = static_cast<std::size_t>(kUnknowns);

    /// By columns. On the diagonal of L, what it is divided by is kept inverted.
    using Block = std::array<double, kSize * kSize>;

    /// The blocks of a row of the lower triangle, so that block (row, column) is
    /// rowOf(row)[column]; only those in the band (or in the border) exist.
    [[nodiscard]] Block* rowOf(int row) { return blocks_.data() + offsets_[row]; }

    [[nodiscard]] const Block* rowOf(int row) const { return blocks_.data() + offsets_[row]; }

    [[nodiscard]] int firstColumn(int row) const;

    void solveLower(int first, int last, double* unknowns) const;
    void solveUpper(int first, int last, double* unknowns) const;
    static void subtractProduct(Block& c, const Block& a, const Block& b);
    static void divideByTransposed(Block& x, const Block& diagonal);
    static bool factoriseDiagonal(Block& a);

    int points_, bandwidth_, banded_;  // banded_: rows before the border
    std::vector<Block> blocks_;        // row by row
    std::vector<std::ptrdiff_t> offsets_;
};

extern template class BandCholesky<1>;
extern template class BandCholesky<3>;

}  // namespace bspline_curve
