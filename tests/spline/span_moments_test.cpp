// SPDX-License-Identifier: GPL-3.0-or-later
// Sums over points of a span by their moments, against the sums themselves.
#include "spline/span_moments.h"

#include "basis_derivative.h"
#include "solver/energy_derivatives.h"
#include "support/random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bspline_curve {
namespace {

using test_support::Random;

class Moments : public testing::TestWithParam<int> {
protected:
    SplineSpace space_{GetParam(), false, {0.0, 0.03, 0.2, 0.25, 0.9, 1.0}};
    Random random_{7};
};

TEST_P(Moments, BernsteinFormsHaveTheBasisValues) {
    for (int span = 0; span < space_.spanCount(); ++span) {
        for (const int order : {0, 1, 2}) {
            const SplineSpace::BasisMatrix basis = space_.bernsteinBasis(span, order);
            const int n = space_.degree() - order;
            for (const double tau : {0.0, 0.3, 1.0}) {
                const SplineSpace::BasisValues expected =
                    test_support::basisDerivative(space_, span, tau, order);
                for (int j = 0; j < space_.basisCount(); ++j) {
                    double value = 0.0;
                    for (int k = 0; k <= n; ++k) {
                        value += basis(j, k) * std::pow(tau, k) * std::pow(1.0 - tau, n - k);
                    }
                    const double wanted = expected[j];
                    EXPECT_NEAR(value, wanted, 1e-13 * basis.norm());
                }
            }
        }
    }
}

TEST_P(Moments, GiveTheSumsOverPoints) {
    for (const int order : {0, 2}) {
        for (int span = 0; span < space_.spanCount(); ++span) {
            SpanMoments moments(space_.degree() - order);
            const int size = 3 * space_.basisCount();
            SpanMatrix expected = SpanMatrix::Zero(size, size);
            Eigen::VectorXd expectedGradient = Eigen::VectorXd::Zero(3 * space_.controlCount());
            for (int i = 0; i < 20; ++i) {
                const double tau = random_.uniform(0.0, 1.0);
                const SplineSpace::BasisValues values =
                    test_support::basisDerivative(space_, span, tau, order);
                const Vec3 force = random_.point(-1.0, 1.0);
                const Vec3 direction = random_.point(-1.0, 1.0);
                const double scale = random_.uniform(-1.0, 1.0);
                moments.addForce(tau, force);
                moments.addMatrix(tau, rankOne(direction, scale));
                SpanVector along(size);
                for (int j = 0; j < space_.basisCount(); ++j) {
                    along.segment<3>(3 * j) = values[j] * direction;
                    expectedGradient.segment<3>(3 * space_.control(span, j)) += values[j] * force;
                }
                expected += scale * along * along.transpose();
            }
            const SplineSpace::BasisMatrix basis = space_.bernsteinBasis(span, order);
            SpanBlocks blocks{};
            Eigen::VectorXd gradient = Eigen::VectorXd::Zero(expectedGradient.size());
            moments.addMatricesTo(blocks, basis, space_.basisCount());
            moments.addForcesTo(gradient, space_, span, basis);
            EXPECT_LT(
                (dense(blocks, space_.basisCount()) - expected).norm(), 1e-13 * expected.norm()
            );
            EXPECT_LT((gradient - expectedGradient).norm(), 1e-13 * expectedGradient.norm());
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Degrees, Moments, testing::Values(2, 3, 4));

TEST(DerivativesAtAPoint, AddRankOneAndSymmetricProducts) {
    Random random(3);
    const Vec3 a = random.point(-1.0, 1.0);
    const Vec3 b = random.point(-1.0, 1.0);
    PointDerivatives point;
    point.addRankOne(a, 2.0);
    point.addProduct(a, b, -3.0);
    const Eigen::Matrix3d expected =
        2.0 * a * a.transpose() - 3.0 * (a * b.transpose() + b * a.transpose());
    std::size_t entry = 0;
    for (int row = 0; row < 3; ++row) {
        for (int column = row; column < 3; ++column, ++entry) {
            EXPECT_NEAR(point.second[entry], expected(row, column), 1e-14);
        }
    }
}

}  // namespace
}  // namespace bspline_curve
