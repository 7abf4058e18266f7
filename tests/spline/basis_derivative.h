// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spline/spline_space.h"

namespace bspline_curve::test_support {

/// Derivatives of the given order by t (not tau) of the basis functions of a span at tau.
[[nodiscard]] SplineSpace::BasisValues basisDerivative(
    const SplineSpace& space, int span, double tau, int order
);

}  // namespace bspline_curve::test_support
