// SPDX-License-Identifier: GPL-3.0-or-later
#include "spline/polynomial_curve.h"

namespace bspline_curve {

PolynomialCurve PolynomialCurve::shifted(double start) const {
    PolynomialCurve result = *this;
    for (int i = 0; i < degree; ++i) {
        for (int j = degree; j-- > i;) {
            result.coefficients[j] += start * result.coefficients[j + 1];
        }
    }
    return result;
}

}  // namespace bspline_curve
