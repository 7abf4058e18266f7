// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/band_cholesky.h"

#include <algorithm>
#include <cmath>

namespace bspline_curve {

BandCholesky::BandCholesky(int points, int bandwidth, int border)
    : points_(points), bandwidth_(bandwidth), banded_(points - border) {
    std::ptrdiff_t count = 0;
    for (int row = 0; row < points; ++row) {
        offsets_.push_back(count - firstColumn(row));
        count += row - firstColumn(row) + 1;
    }
    blocks_.resize(static_cast<std::size_t>(count));
    clear();
}

int BandCholesky::firstColumn(int row) const {
    return row < banded_ ? std::max(0, row - bandwidth_) : 0;
}

void BandCholesky::clear() {
    std::ranges::fill(blocks_, Block{});
}

void BandCholesky::add(int row, int column, const double* values, std::ptrdiff_t stride) {
    Block& block = rowOf(row)[column];
    for (std::size_t c = 0; c < 3; ++c, values += stride) {
        for (std::size_t r = 0; r < 3; ++r) {
            block[3 * c + r] += values[r];
        }
    }
}

// c -= a b^T
void BandCholesky::subtractProduct(Block& c, const Block& a, const Block& b) {
    for (std::size_t column = 0; column < 3; ++column) {
        for (std::size_t row = 0; row < 3; ++row) {
            c[3 * column + row] -=
                a[row] * b[column] + a[3 + row] * b[3 + column] + a[6 + row] * b[6 + column];
        }
    }
}

// x becomes x D^-T for a lower triangular D.
void BandCholesky::divideByTransposed(Block& x, const Block& diagonal) {
    for (std::size_t row = 0; row < 3; ++row) {
        x[row] *= diagonal[0];
        x[3 + row] = (x[3 + row] - x[row] * diagonal[1]) * diagonal[4];
        x[6 + row] = (x[6 + row] - x[row] * diagonal[2] - x[3 + row] * diagonal[5]) * diagonal[8];
    }
}

// The lower triangle of a becomes its own factor. False where it is not positive definite.
bool BandCholesky::factoriseDiagonal(Block& a) {
    for (std::size_t column = 0; column < 3; ++column) {
        double* const values = a.data() + 3 * column;
        for (std::size_t before = 0; before < column; ++before) {
            const double* const other = a.data() + 3 * before;
            for (std::size_t row = column; row < 3; ++row) {
                values[row] -= other[row] * other[column];
            }
        }
        const double pivot = values[column];
        const bool isPositive = pivot > 0.0;  // NaN is not
        if (!isPositive) {
            return false;
        }
        values[column] = 1.0 / std::sqrt(pivot);
        for (std::size_t row = column + 1; row < 3; ++row) {
            values[row] *= values[column];
        }
    }
    return true;
}

// Row by row; row i of L needs the rows before it alone.
bool BandCholesky::factorise() {
    for (int i = 0; i < points_; ++i) {
        Block* const row = rowOf(i);
        const int first = firstColumn(i);
        for (int j = first; j < i; ++j) {
            const Block* const other = rowOf(j);
            for (int k = std::max(first, firstColumn(j)); k < j; ++k) {
                subtractProduct(row[j], row[k], other[k]);
            }
            divideByTransposed(row[j], other[j]);
            subtractProduct(row[i], row[j], row[j]);
        }
        if (!factoriseDiagonal(row[i])) {
            return false;
        }
    }
    return true;
}

Eigen::VectorXd BandCholesky::solve(Eigen::VectorXd right) const {
    for (int i = 0; i < points_; ++i) {
        const Block* const row = rowOf(i);
        double* const x = right.data() + 3 * static_cast<std::ptrdiff_t>(i);
        for (int j = firstColumn(i); j < i; ++j) {
            const double* const y = right.data() + 3 * static_cast<std::ptrdiff_t>(j);
            for (std::size_t r = 0; r < 3; ++r) {
                x[r] -= row[j][r] * y[0] + row[j][3 + r] * y[1] + row[j][6 + r] * y[2];
            }
        }
        const Block& diagonal = row[i];
        x[0] *= diagonal[0];
        x[1] = (x[1] - diagonal[1] * x[0]) * diagonal[4];
        x[2] = (x[2] - diagonal[2] * x[0] - diagonal[5] * x[1]) * diagonal[8];
    }
    for (int i = points_ - 1; i >= 0; --i) {
        const Block* const row = rowOf(i);
        double* const x = right.data() + 3 * static_cast<std::ptrdiff_t>(i);
        const Block& diagonal = row[i];
        x[2] *= diagonal[8];
        x[1] = (x[1] - diagonal[5] * x[2]) * diagonal[4];
        x[0] = (x[0] - diagonal[1] * x[1] - diagonal[2] * x[2]) * diagonal[0];
        for (int j = firstColumn(i); j < i; ++j) {
            double* const y = right.data() + 3 * static_cast<std::ptrdiff_t>(j);
            const double* values = row[j].data();
            for (std::size_t r = 0; r < 3; ++r, values += 3) {
                y[r] -= values[0] * x[0] + values[1] * x[1] + values[2] * x[2];
            }
        }
    }
    return right;
}

}  // namespace bspline_curve
