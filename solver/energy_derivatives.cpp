// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/energy_derivatives.h"

namespace bspline_curve {
void EnergyDerivatives::reset(const SplineSpace& space) {
    const int size = 3 * space.basisCount();
    gradient = Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(space.controlCount()));
    hessian.assign(space.spanCount(), SpanMatrix::Zero(size, size));
    negativeKinks.assign(space.spanCount(), SpanMatrix::Zero(size, size));
}

void addRankOne(
    SpanMatrix& block,
    const SplineSpace::BasisValues& basis,
    const Vec3& direction,
    double scale,
    int basisCount
) {
    std::array<double, kMaxSpanUnknowns> v{};
    const int size = 3 * basisCount;
    for (int j = 0; j < basisCount; ++j) {
        for (int axis = 0; axis < 3; ++axis) {
            v[3 * j + axis] = basis[j] * direction[axis];
        }
    }
    double* data = block.data();
    for (int j = 0; j < size; ++j) {
        const double factor = scale * v[j];
        for (int i = 0; i < size; ++i) {
            data[j * size + i] += factor * v[i];
        }
    }
}

void DerivativeCollector::finish() {
    if (points_.empty() && negativeKinks_.empty()) {
        return;
    }
    const SplineSpace::BasisMatrix basis = space_.bernsteinBasis(span_);
    points_.addForcesTo(derivatives_.gradient, space_, span_, basis);
    points_.addMatricesTo(derivatives_.hessian[span_], basis, space_.basisCount());
    negativeKinks_.addMatricesTo(derivatives_.negativeKinks[span_], basis, space_.basisCount());
    points_.clear();
    negativeKinks_.clear();
}

void addGradient(
    Eigen::VectorXd& gradient,
    const SplineSpace& space,
    int span,
    const SplineSpace::BasisValues& basis,
    const Vec3& force
) {
    for (int j = 0; j < space.basisCount(); ++j) {
        gradient.segment<3>(3 * space.control(span, j)) += basis[j] * force;
    }
}

}  // namespace bspline_curve
