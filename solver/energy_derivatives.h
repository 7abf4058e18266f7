// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/spline_space.h"
#include "solver/spline_system.h"

#include <array>
#include <vector>

namespace bspline_curve {

/// First and second derivatives of the energy by the control points: the gradient, and the Hessian
/// as span blocks. The part of the Hessian that kinks of the integrand at cell walls subtract is
/// kept apart, so that it can be damped.
struct EnergyDerivatives {
    Eigen::VectorXd gradient;
    std::vector<SpanMatrix> hessian;
    std::vector<SpanMatrix> negativeKinks;

    void reset(const SplineSpace& space);
};

/// block += scale v v^T with v = basis (x) direction: the second derivative of scale / 2 (direction
/// . P)^2.
void addRankOne(
    SpanMatrix& block,
    const SplineSpace::BasisValues& basis,
    const Vec3& direction,
    double scale,
    int basisCount
);

/// Sum of scale b b^T over points whose basis values are b: the part of many rank-one terms with
/// one direction that differs between them.
class BasisProducts {
public:
    void add(const SplineSpace::BasisValues& basis, double scale, int basisCount) {
        for (int i = 0; i < basisCount; ++i) {
            const double factor = scale * basis[static_cast<std::size_t>(i)];
            for (int j = 0; j < basisCount; ++j) {
                sums_[static_cast<std::size_t>(i * kMaxBasis + j)] +=
                    factor * basis[static_cast<std::size_t>(j)];
            }
        }
    }

    /// block += sums (x) direction direction^T.
    void addTo(SpanMatrix& block, const Vec3& direction, int basisCount) const {
        addOuter(block, direction * direction.transpose(), basisCount);
    }

    /// block += sums (x) (a b^T + b a^T).
    void addTo(SpanMatrix& block, const Vec3& a, const Vec3& b, int basisCount) const {
        const Eigen::Matrix3d outer = a * b.transpose();
        addOuter(block, outer + outer.transpose(), basisCount);
    }

private:
    void addOuter(SpanMatrix& block, const Eigen::Matrix3d& outer, int basisCount) const;

    std::array<double, static_cast<std::size_t>(kMaxBasis) * kMaxBasis> sums_{};
};

/// gradient += basis (x) force on the control points of a span.
void addGradient(
    Eigen::VectorXd& gradient,
    const SplineSpace& space,
    int span,
    const SplineSpace::BasisValues& basis,
    const Vec3& force
);

}  // namespace bspline_curve
