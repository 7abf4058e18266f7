// SPDX-License-Identifier: GPL-3.0-or-later
#include "spline/band_cholesky.h"

#include <algorithm>
#include <cmath>

namespace bspline_curve {

template <int kUnknowns>
BandCholesky<kUnknowns>::BandCholesky(int points, int bandwidth, int border)
    : points_(points), bandwidth_(bandwidth), banded_(points - border) {
    std::ptrdiff_t count = 0;
    for (int row = 0; row < points; ++row) {
        offsets_.push_back(count - firstColumn(row));
        count += row - firstColumn(row) + 1;
    }
    blocks_.resize(static_cast<std::size_t>(count));
    clear();
}

template <int kUnknowns>
int BandCholesky<kUnknowns>::firstColumn(int row) const {
    return row < banded_ ? std::max(0, row - bandwidth_) : 0;
}

template <int kUnknowns>
void BandCholesky<kUnknowns>::clear() {
    std::ranges::fill(blocks_, Block{});
}

template <int kUnknowns>
void BandCholesky<kUnknowns>::add(
    int row, int column, const double* values, std::ptrdiff_t stride
) {
    Block& block = rowOf(row)[column];
    for (std::size_t c = 0; c < kSize; ++c, values += stride) {
        for (std::size_t r = 0; r < kSize; ++r) {
            block[kSize * c + r] += values[r];
        }
    }
}

// c -= a b^T
template <int kUnknowns>
void BandCholesky<kUnknowns>::subtractProduct(Block& c, const Block& a, const Block& b) {
    for (std::size_t column = 0; column < kSize; ++column) {
        for (std::size_t row = 0; row < kSize; ++row) {
            double sum = a[row] * b[column];
            for (std::size_t k = 1; k < kSize; ++k) {
                sum += a[kSize * k + row] * b[kSize * k + column];
            }
            c[kSize * column + row] -= sum;
        }
    }
}

// x becomes x D^-T for a lower triangular D.
template <int kUnknowns>
void BandCholesky<kUnknowns>::divideByTransposed(Block& x, const Block& diagonal) {
    for (std::size_t row = 0; row < kSize; ++row) {
        for (std::size_t column = 0; column < kSize; ++column) {
            double& value = x[kSize * column + row];
            for (std::size_t k = 0; k < column; ++k) {
                value -= x[kSize * k + row] * diagonal[kSize * k + column];
            }
            value *= diagonal[(kSize + 1) * column];
        }
    }
}

// The lower triangle of a becomes its own factor. False where it is not positive definite.
template <int kUnknowns>
bool BandCholesky<kUnknowns>::factoriseDiagonal(Block& a) {
    for (std::size_t column = 0; column < kSize; ++column) {
        double* const values = a.data() + kSize * column;
        for (std::size_t before = 0; before < column; ++before) {
            const double* const other = a.data() + kSize * before;
            for (std::size_t row = column; row < kSize; ++row) {
                values[row] -= other[row] * other[column];
            }
        }
        const double pivot = values[column];
        const bool isPositive = pivot > 0.0;  // NaN is not
        if (!isPositive) {
            return false;
        }
        values[column] = 1.0 / std::sqrt(pivot);
        for (std::size_t row = column + 1; row < kSize; ++row) {
            values[row] *= values[column];
        }
    }
    return true;
}

// Row by row; row i of L needs the rows before it alone.
template <int kUnknowns>
bool BandCholesky<kUnknowns>::factorise() {
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

// L y = right, in place, for rows from first to last alone, where y is 0 before.
template <int kUnknowns>
void BandCholesky<kUnknowns>::solveLower(int first, int last, double* unknowns) const {
    const auto unknownsOf = [&](int point) {
        return unknowns + kUnknowns * static_cast<std::ptrdiff_t>(point);
    };
    for (int i = first; i <= last; ++i) {
        const Block* const row = rowOf(i);
        double* const x = unknownsOf(i);
        for (int j = std::max(first, firstColumn(i)); j < i; ++j) {
            const double* const y = unknownsOf(j);
            for (std::size_t r = 0; r < kSize; ++r) {
                double sum = row[j][r] * y[0];
                for (std::size_t k = 1; k < kSize; ++k) {
                    sum += row[j][kSize * k + r] * y[k];
                }
                x[r] -= sum;
            }
        }
        const Block& diagonal = row[i];
        for (std::size_t r = 0; r < kSize; ++r) {
            for (std::size_t k = 0; k < r; ++k) {
                x[r] -= diagonal[kSize * k + r] * x[k];
            }
            x[r] *= diagonal[(kSize + 1) * r];
        }
    }
}

// L^T x = y, in place, likewise where x is 0 behind.
template <int kUnknowns>
void BandCholesky<kUnknowns>::solveUpper(int first, int last, double* unknowns) const {
    const auto unknownsOf = [&](int point) {
        return unknowns + kUnknowns * static_cast<std::ptrdiff_t>(point);
    };
    for (int i = last; i >= first; --i) {
        const Block* const row = rowOf(i);
        double* const x = unknownsOf(i);
        const Block& diagonal = row[i];
        for (std::size_t r = kSize; r-- > 0;) {
            for (std::size_t k = r + 1; k < kSize; ++k) {
                x[r] -= diagonal[kSize * r + k] * x[k];
            }
            x[r] *= diagonal[(kSize + 1) * r];
        }
        for (int j = std::max(first, firstColumn(i)); j < i; ++j) {
            double* const y = unknownsOf(j);
            for (std::size_t r = 0; r < kSize; ++r) {
                const double* const values = row[j].data() + kSize * r;
                double sum = values[0] * x[0];
                for (std::size_t k = 1; k < kSize; ++k) {
                    sum += values[k] * x[k];
                }
                y[r] -= sum;
            }
        }
    }
}

template <int kUnknowns>
Eigen::VectorXd BandCholesky<kUnknowns>::solve(Eigen::VectorXd right) const {
    solveLower(0, points_ - 1, right.data());
    solveUpper(0, points_ - 1, right.data());
    return right;
}

template <int kUnknowns>
void BandCholesky<kUnknowns>::solveBetween(int first, int last, Eigen::VectorXd& right) const {
    solveLower(first, last, right.data());
    solveUpper(first, last, right.data());
}

template class BandCholesky<1>;
template class BandCholesky<3>;

}  // namespace bspline_curve
