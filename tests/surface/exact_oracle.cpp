// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact_oracle.h"

#include <cstddef>
#include <utility>

namespace bspline_curve::exact_oracle {

namespace {

using Column = std::vector<std::int64_t>;

Point minus(const Point& a, const Point& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// A column of a system: three coordinates times a sign, then further rows.
Column column(const Point& point, std::int64_t sign, std::initializer_list<std::int64_t> rows) {
    Column result{sign * point[0], sign * point[1], sign * point[2]};
    result.insert(result.end(), rows);
    return result;
}

/// Whether the columns are independent and combine to the right-hand side without negative
/// coefficients. Fraction-free Gauss-Jordan elimination.
bool isFeasibleBasis(const std::vector<Column>& columns, const Column& rightHandSide) {
    const std::size_t rowCount = rightHandSide.size();
    const std::size_t columnCount = columns.size();
    std::vector<std::vector<Integer>> matrix(rowCount, std::vector<Integer>(columnCount + 1));
    for (std::size_t r = 0; r < rowCount; ++r) {
        for (std::size_t c = 0; c < columnCount; ++c) {
            matrix[r][c] = columns[c][r];
        }
        matrix[r][columnCount] = rightHandSide[r];
    }

    Integer previousPivot = 1;
    for (std::size_t c = 0; c < columnCount; ++c) {
        std::size_t pivotRow = c;
        while (pivotRow < rowCount && matrix[pivotRow][c] == 0) {
            ++pivotRow;
        }
        if (pivotRow == rowCount) {
            return false;
        }
        std::swap(matrix[c], matrix[pivotRow]);
        const Integer pivot = matrix[c][c];
        for (std::size_t r = 0; r < rowCount; ++r) {
            if (r == c) {
                continue;
            }
            const Integer factor = matrix[r][c];
            for (std::size_t k = 0; k <= columnCount; ++k) {
                // Bareiss: the division leaves no remainder.
                matrix[r][k] = (pivot * matrix[r][k] - factor * matrix[c][k]) / previousPivot;
            }
        }
        previousPivot = pivot;
    }
    for (std::size_t r = 0; r < rowCount; ++r) {
        const Integer value = matrix[r][columnCount];
        const bool isConsistent = r < columnCount ? value * previousPivot >= 0 : value == 0;
        if (!isConsistent) {
            return false;
        }
    }
    return true;
}

/// Whether some combination of the columns without negative coefficients is the right-hand side.
bool isFeasible(const std::vector<Column>& columns, const Column& rightHandSide) {
    for (std::size_t subset = 1; subset < (std::size_t{1} << columns.size()); ++subset) {
        std::vector<Column> basis;
        for (std::size_t c = 0; c < columns.size(); ++c) {
            if ((subset >> c & 1U) != 0) {
                basis.push_back(columns[c]);
            }
        }
        if (basis.size() <= rightHandSide.size() && isFeasibleBasis(basis, rightHandSide)) {
            return true;
        }
    }
    return false;
}

}  // namespace

int orientationSign(const Point& a, const Point& b, const Point& c, const Point& d) {
    const Point u = minus(b, a);
    const Point v = minus(c, a);
    const Point w = minus(d, a);
    const auto minor = [&](std::size_t i, std::size_t j) {
        return Integer{v[i]} * w[j] - Integer{v[j]} * w[i];
    };
    const Integer determinant = u[0] * minor(1, 2) + u[1] * minor(2, 0) + u[2] * minor(0, 1);
    return (determinant > 0 ? 1 : 0) - (determinant < 0 ? 1 : 0);
}

bool trianglesMeet(
    const std::array<Point, 3>& a, const std::array<Point, 3>& b, int sharedCorners
) {
    if (sharedCorners == 0) {
        // sum x_i a_i - sum y_i b_i = 0, sum x_i = 1, sum y_i = 1
        return isFeasible(
            {column(a[0], 1, {1, 0}),
             column(a[1], 1, {1, 0}),
             column(a[2], 1, {1, 0}),
             column(b[0], -1, {0, 1}),
             column(b[1], -1, {0, 1}),
             column(b[2], -1, {0, 1})},
            {0, 0, 0, 1, 1}
        );
    }
    if (sharedCorners == 1) {
        // With the corner at the origin: x_1 a_1 + x_2 a_2 = y_1 b_1 + y_2 b_2, x_1 + x_2 = 1
        return isFeasible(
            {column(minus(a[1], a[0]), 1, {1}),
             column(minus(a[2], a[0]), 1, {1}),
             column(minus(b[1], b[0]), -1, {0}),
             column(minus(b[2], b[0]), -1, {0})},
            {0, 0, 0, 1}
        );
    }
    // With the edge's start at the origin: y b_2 + (s - t) (end of the edge) = a_2
    const Point edge = minus(a[1], a[0]);
    const Point apex = minus(a[2], a[0]);
    return isFeasible(
        {column(minus(b[2], b[0]), 1, {}), column(edge, 1, {}), column(edge, -1, {})},
        {apex[0], apex[1], apex[2]}
    );
}

}  // namespace bspline_curve::exact_oracle
