// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/energy_derivatives.h"

namespace bspline_curve {
void EnergyDerivatives::reset(const SplineSpace& space) {
    gradient = Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(space.controlCount()));
    hessian.assign(space.spanCount(), SpanBlocks{});
    negativeKinks.assign(space.spanCount(), SpanBlocks{});
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

}  // namespace bspline_curve
