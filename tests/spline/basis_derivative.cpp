// SPDX-License-Identifier: GPL-3.0-or-later
#include "basis_derivative.h"

#include <cmath>
#include <cstddef>

namespace bspline_curve::test_support {

SplineSpace::BasisValues basisDerivative(
    const SplineSpace& space, int span, double tau, int order
) {
    const SplineSpace::BasisMatrix& table = space.basis(span);
    const double scale = std::pow(space.spanLength(span), -order);
    SplineSpace::BasisValues values{};
    for (int j = 0; j <= space.degree(); ++j) {
        double value = 0.0;
        for (int m = space.degree(); m >= order; --m) {
            double factor = 1.0;
            for (int i = 0; i < order; ++i) {
                factor *= m - i;
            }
            value = value * tau + factor * table(j, m);
        }
        values[j] = value * scale;
    }
    return values;
}

}  // namespace bspline_curve::test_support
