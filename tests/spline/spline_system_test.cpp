// SPDX-License-Identifier: GPL-3.0-or-later
#include "spline/spline_system.h"

#include "spline/basis_derivative.h"
#include "support/random.h"

#include <Eigen/LU>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <tuple>

namespace bspline_curve {
namespace {

using test_support::Random;

// A spline space with constraints and a Hessian, beside the same as dense matrices.
class SplineSystems : public testing::TestWithParam<std::tuple<int, bool>> {
protected:
    static constexpr std::uint64_t kSeed = 77;
    static constexpr int kSpans = 8;

    static SplineSpace makeSpace() {
        std::vector<double> breaks;
        for (int i = 0; i <= kSpans; ++i) {
            breaks.push_back(static_cast<double>(i) / kSpans);
        }
        return {std::get<0>(GetParam()), std::get<1>(GetParam()), breaks};
    }

    void SetUp() override {
        for (const double t : {0.0, 0.25, 0.43, 0.75, 1.0}) {
            if (!space_.closed() || t < 1.0) {
                picks_.push_back({{}, random_.point(-0.5, 0.5), t});
            }
        }
    }

    [[nodiscard]] SplineSystem makeSystem() const {
        return {space_, interpolationRows(space_, picks_)};
    }

    // Sums of products v v^T (x) m, with m a positive semidefinite matrix of the axes.
    void addProduct(
        SpanBlocks& blocks, const SplineSpace::BasisValues& v, const SymmetricMatrix& m
    ) {
        for (int j = 0; j < space_.basisCount(); ++j) {
            for (int k = 0; k <= j; ++k) {
                blocks[blockIndex(j, k)] += (v[j] * v[k]) * m;
            }
        }
    }

    // Positive semidefinite blocks whose sum is positive definite.
    [[nodiscard]] std::vector<SpanBlocks> randomBlocks() {
        std::vector<SpanBlocks> blocks(kSpans);
        for (SpanBlocks& span : blocks) {
            for (int i = 0; i < 3 * space_.basisCount(); ++i) {
                SplineSpace::BasisValues values{};
                for (double& value : values) {
                    value = random_.uniform(-1.0, 1.0);
                }
                addProduct(span, values, rankOne(random_.point(-1.0, 1.0), 1.0));
            }
        }
        return blocks;
    }

    // Those of the integral of |P''|^2: without the constraints singular.
    [[nodiscard]] std::vector<SpanBlocks> bendingBlocks() {
        std::vector<SpanBlocks> blocks(kSpans);
        for (int span = 0; span < kSpans; ++span) {
            const double weight = 0.25 * space_.spanLength(span);
            for (const double tau : {0.1, 0.35, 0.65, 0.9}) {
                addProduct(
                    blocks[span],
                    test_support::basisDerivative(space_, span, tau, 2),
                    {weight, 0.0, 0.0, weight, 0.0, weight}
                );
            }
        }
        return blocks;
    }

    [[nodiscard]] Eigen::MatrixXd denseSum(const std::vector<SpanBlocks>& blocks) const {
        const int n = 3 * space_.controlCount();
        Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
        for (int span = 0; span < kSpans; ++span) {
            const SpanMatrix block = dense(blocks[span], space_.basisCount());
            for (int i = 0; i < space_.basisCount(); ++i) {
                for (int j = 0; j < space_.basisCount(); ++j) {
                    matrix.block<3, 3>(3 * space_.control(span, i), 3 * space_.control(span, j)) +=
                        block.block<3, 3>(3 * i, 3 * j);
                }
            }
        }
        return matrix;
    }

    [[nodiscard]] Eigen::MatrixXd denseConstraints(const SplineSystem& system) const {
        const auto rows = 3 * static_cast<Eigen::Index>(system.constraints().rows().size());
        Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(rows, 3 * space_.controlCount());
        for (std::size_t r = 0; r < system.constraints().rows().size(); ++r) {
            const InterpolationRow& row = system.constraints().rows()[r];
            for (int j = 0; j < space_.basisCount(); ++j) {
                for (int axis = 0; axis < 3; ++axis) {
                    matrix(
                        3 * static_cast<Eigen::Index>(r) + axis,
                        3 * space_.control(row.span, j) + axis
                    ) += row.values[j];
                }
            }
        }
        return matrix;
    }

    [[nodiscard]] Eigen::VectorXd randomVector(Eigen::Index size) {
        Eigen::VectorXd vector(size);
        for (double& value : vector) {
            value = random_.uniform(-1.0, 1.0);
        }
        return vector;
    }

    void expectConstrainedStep(const std::vector<SpanBlocks>& blocks);

    Random random_{kSeed};
    SplineSpace space_ = makeSpace();
    std::vector<PickConstraint> picks_;
    testing::ScopedTrace trace_{__FILE__, __LINE__, "seed " + std::to_string(kSeed)};
};

void SplineSystems::expectConstrainedStep(const std::vector<SpanBlocks>& blocks) {
    SplineSystem system = makeSystem();
    const Eigen::MatrixXd H = denseSum(blocks);
    const Eigen::MatrixXd A = denseConstraints(system);
    const double weight = 1e3 * H.diagonal().maxCoeff();
    ASSERT_TRUE(system.factorise(blocks, weight));

    const Eigen::VectorXd gradient = H.norm() * randomVector(H.rows());
    const Eigen::VectorXd residual = randomVector(A.rows());
    const Eigen::VectorXd step = system.constrainedStep(gradient, residual, weight);

    Eigen::MatrixXd kkt = Eigen::MatrixXd::Zero(H.rows() + A.rows(), H.rows() + A.rows());
    kkt << H, A.transpose(), A, Eigen::MatrixXd::Zero(A.rows(), A.rows());
    Eigen::VectorXd right(H.rows() + A.rows());
    right << -gradient, -residual;
    const Eigen::VectorXd expected = kkt.fullPivLu().solve(right).head(H.rows());
    EXPECT_LT((step - expected).norm(), 1e-8 * expected.norm());
    EXPECT_LT((A * step + residual).lpNorm<Eigen::Infinity>(), 1e-10);
}

TEST_P(SplineSystems, ConstrainedStepsSolveTheSaddlePointSystem) {
    expectConstrainedStep(randomBlocks());
}

TEST_P(SplineSystems, ConstrainedStepsSolveItForBendingToo) {
    expectConstrainedStep(bendingBlocks());
}

TEST_P(SplineSystems, SolvesWithTheConstraintsAsAPenalty) {
    SplineSystem system = makeSystem();
    const std::vector<SpanBlocks> blocks = randomBlocks();
    const Eigen::MatrixXd A = denseConstraints(system);
    ASSERT_TRUE(system.factorise(blocks, 7.0));
    const Eigen::MatrixXd H = denseSum(blocks) + 7.0 * A.transpose() * A;
    const Eigen::VectorXd right = randomVector(H.rows());
    EXPECT_LT((H * system.solve(right) - right).norm(), 1e-9 * right.norm());
}

TEST_P(SplineSystems, RefusesIndefiniteMatrices) {
    SplineSystem system = makeSystem();
    std::vector<SpanBlocks> blocks = randomBlocks();
    EXPECT_TRUE(system.factorise(blocks, 0.0));
    for (int j = 0; j < space_.basisCount(); ++j) {
        blocks[3][blockIndex(j, j)] += {-1e3, 0.0, 0.0, -1e3, 0.0, -1e3};
    }
    EXPECT_FALSE(system.factorise(blocks, 0.0));
    EXPECT_FALSE(system.factorise(blocks, 1.0));
    // And is none the worse for it.
    EXPECT_TRUE(system.factorise(randomBlocks(), 0.0));
}

TEST_P(SplineSystems, ResidualsAreTheGapsAtThePicks) {
    const SplineSystem system = makeSystem();
    ControlPoints controls(space_.controlCount(), 3);
    for (int i = 0; i < space_.controlCount(); ++i) {
        controls.row(i) = random_.point(-1.0, 1.0).transpose();
    }
    const Eigen::VectorXd residual = system.constraints().residual(controls);
    ASSERT_EQ(residual.size(), 3 * static_cast<Eigen::Index>(picks_.size()));
    for (std::size_t i = 0; i < picks_.size(); ++i) {
        const Vec3 gap = space_.evaluate(controls, picks_[i].parameter) - picks_[i].position;
        EXPECT_LT((residual.segment<3>(3 * static_cast<Eigen::Index>(i)) - gap).norm(), 1e-14);
    }
}

TEST_P(SplineSystems, TheTransposeIsTheTranspose) {
    const SplineSystem system = makeSystem();
    const Eigen::MatrixXd A = denseConstraints(system);
    const Eigen::VectorXd multipliers = randomVector(A.rows());
    Eigen::VectorXd out = Eigen::VectorXd::Zero(A.cols());
    system.constraints().addTransposed(multipliers, out);
    EXPECT_LT((out - A.transpose() * multipliers).norm(), 1e-13);
    const Eigen::VectorXd x = randomVector(A.cols());
    EXPECT_LT((system.constraints().apply(x) - A * x).norm(), 1e-13);
}

INSTANTIATE_TEST_SUITE_P(
    All,
    SplineSystems,
    testing::Combine(testing::Values(2, 3, 4), testing::Bool()),
    [](const auto& testInfo) {
        return (std::get<1>(testInfo.param) ? "ClosedDegree" : "OpenDegree") +
               std::to_string(std::get<0>(testInfo.param));
    }
);

}  // namespace
}  // namespace bspline_curve
