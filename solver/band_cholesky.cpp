// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/band_cholesky.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bspline_curve {
namespace {

// Four sums, which the compiler keeps in two registers; always added in the same order.
double dot(const double* a, const double* b, int count) {
    double s0 = 0.0;
    double s1 = 0.0;
    double s2 = 0.0;
    double s3 = 0.0;
    int i = 0;
    for (; i + 4 <= count; i += 4) {
        s0 += a[i] * b[i];
        s1 += a[i + 1] * b[i + 1];
        s2 += a[i + 2] * b[i + 2];
        s3 += a[i + 3] * b[i + 3];
    }
    for (; i < count; ++i) {
        s0 += a[i] * b[i];
    }
    return (s0 + s2) + (s1 + s3);
}

}  // namespace

BandCholesky::BandCholesky(int size, int bandwidth, int border)
    : size_(size),
      bandwidth_(bandwidth),
      banded_(size - border),
      inverseDiagonal_(static_cast<std::size_t>(size)) {
    std::ptrdiff_t count = 0;
    for (int row = 0; row < size; ++row) {
        offsets_.push_back(count - firstColumn(row));
        count += row - firstColumn(row) + 1;
    }
    entries_.assign(static_cast<std::size_t>(count), 0.0);
}

int BandCholesky::firstColumn(int row) const {
    return row < banded_ ? std::max(0, row - bandwidth_) : 0;
}

void BandCholesky::clear() {
    std::ranges::fill(entries_, 0.0);
}

void BandCholesky::addToRow(int row, int first, int last, const double* values) {
    double* const entries = rowOf(row) + first;
    for (int i = 0; i <= last - first; ++i) {
        entries[i] += values[i];
    }
}

// Row by row; row i of L needs the rows before it alone.
bool BandCholesky::factorise() {
    for (int i = 0; i < size_; ++i) {
        double* const row = rowOf(i);
        const int first = firstColumn(i);
        for (int j = first; j < i; ++j) {
            const int from = std::max(first, firstColumn(j));
            row[j] = (row[j] - dot(row + from, rowOf(j) + from, j - from)) *
                     inverseDiagonal_[static_cast<std::size_t>(j)];
        }
        const double pivot = row[i] - dot(row + first, row + first, i - first);
        const bool isPositive = pivot > 0.0;  // NaN is not
        if (!isPositive) {
            return false;
        }
        row[i] = std::sqrt(pivot);
        inverseDiagonal_[static_cast<std::size_t>(i)] = 1.0 / row[i];
    }
    return true;
}

Eigen::VectorXd BandCholesky::solve(Eigen::VectorXd right) const {
    double* const x = right.data();
    for (int i = 0; i < size_; ++i) {
        const int first = firstColumn(i);
        x[i] = (x[i] - dot(rowOf(i) + first, x + first, i - first)) *
               inverseDiagonal_[static_cast<std::size_t>(i)];
    }
    for (int i = size_ - 1; i >= 0; --i) {
        x[i] *= inverseDiagonal_[static_cast<std::size_t>(i)];
        const double* const row = rowOf(i);
        for (int j = firstColumn(i); j < i; ++j) {
            x[j] -= x[i] * row[j];
        }
    }
    return right;
}

}  // namespace bspline_curve
