// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/band_cholesky.h"

#include "support/random.h"

#include <Eigen/Cholesky>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace bspline_curve {
namespace {

using test_support::Random;

struct Shape {
    int points, bandwidth, border;

    [[nodiscard]] int size() const { return 3 * points; }
};

class BandCholeskyShapes : public testing::TestWithParam<Shape> {
protected:
    [[nodiscard]] static bool isStored(int row, int column) {
        const auto [points, bandwidth, border] = GetParam();
        return row >= points - border || row - column <= bandwidth;
    }

    // Random entries where there may be some, and a heavy diagonal.
    [[nodiscard]] Eigen::MatrixXd randomMatrix() {
        const int size = GetParam().size();
        Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
        for (int row = 0; row < size; ++row) {
            for (int column = 0; column < row; ++column) {
                if (isStored(row / 3, column / 3)) {
                    matrix(row, column) = matrix(column, row) = random_.uniform(-1.0, 1.0);
                }
            }
            matrix(row, row) = size + random_.uniform(0.0, 1.0);
        }
        return matrix;
    }

    static void setTo(const Eigen::MatrixXd& matrix, BandCholesky<3>& factor) {
        factor.clear();
        for (int row = 0; row < GetParam().points; ++row) {
            for (int column = 0; column <= row; ++column) {
                if (isStored(row, column)) {
                    const double* const first = &matrix(3 * row, 3 * column);
                    factor.add(row, column, first, matrix.outerStride());
                }
            }
        }
    }

    Random random_{123};
    BandCholesky<3> factor_{GetParam().points, GetParam().bandwidth, GetParam().border};
};

TEST_P(BandCholeskyShapes, SolveAsDenseOnes) {
    for (int again = 0; again < 3; ++again) {
        const Eigen::MatrixXd matrix = randomMatrix();
        setTo(matrix, factor_);
        ASSERT_TRUE(factor_.factorise());
        Eigen::VectorXd right(GetParam().size());
        for (double& value : right) {
            value = random_.uniform(-1.0, 1.0);
        }
        const Eigen::VectorXd expected = matrix.llt().solve(right);
        EXPECT_LT((factor_.solve(right) - expected).norm(), 1e-14 * (1.0 + expected.norm()));
    }
}

TEST_P(BandCholeskyShapes, KnowWhatIsNotPositiveDefinite) {
    for (const int at : {0, GetParam().size() / 2, GetParam().size() - 1}) {
        Eigen::MatrixXd matrix = randomMatrix();
        matrix(at, at) = -1.0;
        setTo(matrix, factor_);
        EXPECT_FALSE(factor_.factorise()) << at;
    }
    Eigen::MatrixXd matrix = randomMatrix();
    matrix(0, 0) = std::nan("");
    setTo(matrix, factor_);
    EXPECT_FALSE(factor_.factorise());
}

INSTANTIATE_TEST_SUITE_P(
    All,
    BandCholeskyShapes,
    testing::Values(
        Shape{1, 0, 0},
        Shape{13, 0, 0},
        Shape{13, 3, 0},
        Shape{13, 3, 3},
        Shape{13, 20, 0},
        Shape{3, 3, 3},
        Shape{21, 4, 4}
    ),
    [](const testing::TestParamInfo<Shape>& instance) {
        return "Points" + std::to_string(instance.param.points) + "Band" +
               std::to_string(instance.param.bandwidth) + "Border" +
               std::to_string(instance.param.border);
    }
);

}  // namespace
}  // namespace bspline_curve
