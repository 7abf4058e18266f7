// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/spline_space.h"
#include "solver/spline_system.h"

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

/// gradient += basis (x) force on the control points of a span.
void addGradient(
    Eigen::VectorXd& gradient,
    const SplineSpace& space,
    int span,
    const SplineSpace::BasisValues& basis,
    const Vec3& force
);

}  // namespace bspline_curve
