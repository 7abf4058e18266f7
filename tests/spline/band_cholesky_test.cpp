// SPDX-License-Identifier: GPL-3.0-or-later
#include "spline/band_cholesky.h"

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

    [[nodiscard]] bool isStored(int row, int column) const {
        return row >= points - border || row - column <= bandwidth;
    }
};

// Random matrices of a shape, in blocks of so many unknowns, and their factor.
template <int kUnknowns>
class Matrices {
public:
    explicit Matrices(const Shape& shape)
        : shape_(shape), factor_(shape.points, shape.bandwidth, shape.border) {}

    [[nodiscard]] int size() const { return kUnknowns * shape_.points; }

    [[nodiscard]] BandCholesky<kUnknowns>& factor() { return factor_; }

    // Random entries where there may be some, and a heavy diagonal.
    [[nodiscard]] Eigen::MatrixXd random() {
        Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size(), size());
        for (int row = 0; row < size(); ++row) {
            for (int column = 0; column < row; ++column) {
                if (shape_.isStored(row / kUnknowns, column / kUnknowns)) {
                    matrix(row, column) = matrix(column, row) = random_.uniform(-1.0, 1.0);
                }
            }
            matrix(row, row) = size() + random_.uniform(0.0, 1.0);
        }
        return matrix;
    }

    [[nodiscard]] Eigen::VectorXd randomVector() {
        Eigen::VectorXd vector(size());
        for (double& value : vector) {
            value = random_.uniform(-1.0, 1.0);
        }
        return vector;
    }

    void setFactorTo(const Eigen::MatrixXd& matrix) {
        factor_.clear();
        for (int row = 0; row < shape_.points; ++row) {
            for (int column = 0; column <= row; ++column) {
                if (shape_.isStored(row, column)) {
                    const double* const first = &matrix(kUnknowns * row, kUnknowns * column);
                    factor_.add(row, column, first, matrix.outerStride());
                }
            }
        }
    }

private:
    Shape shape_;
    Random random_{123};
    BandCholesky<kUnknowns> factor_;
};

class BandCholeskyShapes : public testing::TestWithParam<Shape> {
protected:
    // With matrices in blocks of one unknown, and of three.
    template <class Check>
    static void forBoth(const Check& check) {
        check(Matrices<1>(GetParam()));
        check(Matrices<3>(GetParam()));
    }
};

TEST_P(BandCholeskyShapes, SolveAsDenseOnes) {
    forBoth([](auto matrices) {
        for (int again = 0; again < 3; ++again) {
            const Eigen::MatrixXd matrix = matrices.random();
            matrices.setFactorTo(matrix);
            ASSERT_TRUE(matrices.factor().factorise());
            const Eigen::VectorXd right = matrices.randomVector();
            const Eigen::VectorXd expected = matrix.llt().solve(right);
            const Eigen::VectorXd found = matrices.factor().solve(right);
            EXPECT_LT((found - expected).norm(), 1e-14 * (1.0 + expected.norm()));
        }
    });
}

TEST_P(BandCholeskyShapes, KnowWhatIsNotPositiveDefinite) {
    forBoth([](auto matrices) {
        for (const int at : {0, matrices.size() / 2, matrices.size() - 1}) {
            Eigen::MatrixXd matrix = matrices.random();
            matrix(at, at) = -1.0;
            matrices.setFactorTo(matrix);
            EXPECT_FALSE(matrices.factor().factorise()) << at;
        }
        Eigen::MatrixXd matrix = matrices.random();
        matrix(0, 0) = std::nan("");
        matrices.setFactorTo(matrix);
        EXPECT_FALSE(matrices.factor().factorise());
    });
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
