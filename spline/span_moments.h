// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spline/span_blocks.h"

#include <array>

namespace bspline_curve {

/// Collects forces and symmetric matrices that act on a spline at parameters of one span, and turns
/// them into derivatives by the control points. On a span the basis functions are polynomials of
/// one degree p, so sums over any number of points are determined by p + 1 moments of the forces
/// and 2 p + 1 of the matrices: a point costs 6 (2 p + 1) multiplications, whatever the number of
/// unknowns.
class SpanMoments {
public:
    /// `degree`: of the polynomials, in [0, kMaxPolynomialDegree].
    explicit SpanMoments(int degree) : degree_(degree) {}

    void clear() { *this = SpanMoments(degree_); }

    [[nodiscard]] bool empty() const { return !hasMatrices_ && !hasForces_; }

    void addForce(double tau, const Vec3& force);
    void addMatrix(double tau, const SymmetricMatrix& matrix);

    /// gradient += sum of basis(tau) (x) force. `basis`: SplineSpace::bernsteinBasis of the span.
    void addForcesTo(
        Eigen::VectorXd& gradient,
        const SplineSpace& space,
        int span,
        const SplineSpace::BasisMatrix& basis
    ) const;
    /// blocks += sum of basis(tau) basis(tau)^T (x) matrix.
    void addMatricesTo(
        SpanBlocks& blocks, const SplineSpace::BasisMatrix& basis, int basisCount
    ) const;

private:
    static constexpr std::size_t kMaxMoments = 2 * kMaxPolynomialDegree + 1;
    using Powers = std::array<double, kMaxMoments>;

    // tau^k (1 - tau)^(n - k), k = 0..n.
    [[nodiscard]] static Powers powers(double tau, std::size_t n);

    int degree_;
    bool hasForces_ = false, hasMatrices_ = false;
    std::array<Vec3, kMaxBasis> forces_{
        Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()
    };
    std::array<SymmetricMatrix, kMaxMoments> matrices_{};
};

inline SpanMoments::Powers SpanMoments::powers(double tau, std::size_t n) {
    Powers result;
    double rising = 1.0;
    for (std::size_t k = 0; k <= n; ++k) {
        result[k] = rising;
        rising *= tau;
    }
    double falling = 1.0;
    for (std::size_t k = n; k-- > 0;) {
        falling *= 1.0 - tau;
        result[k] *= falling;
    }
    return result;
}

inline void SpanMoments::addForce(double tau, const Vec3& force) {
    const auto n = static_cast<std::size_t>(degree_);
    const Powers power = powers(tau, n);
    for (std::size_t k = 0; k <= n; ++k) {
        forces_[k] += power[k] * force;
    }
    hasForces_ = true;
}

inline void SpanMoments::addMatrix(double tau, const SymmetricMatrix& matrix) {
    const std::size_t n = 2 * degree_;
    const Powers power = powers(tau, n);
    for (std::size_t k = 0; k <= n; ++k) {
        for (std::size_t e = 0; e < matrix.size(); ++e) {
            matrices_[k][e] += power[k] * matrix[e];
        }
    }
    hasMatrices_ = true;
}

}  // namespace bspline_curve
