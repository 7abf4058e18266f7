// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spline/band_cholesky.h"
#include "spline/spline_system.h"

namespace bspline_curve {

/// Adds to the matrix of a least-squares fit, over the control points of a spline, the products of
/// the basis functions on a span. `products`: symmetric.
void addProducts(
    BandCholesky<1>& matrix,
    const SplineSpace& space,
    int span,
    const SplineSpace::BasisMatrix& products
);

/// Adds `weight` A^T A, with the rows of the constraints.
void addProducts(
    BandCholesky<1>& matrix, const SplineSpace& space, const PickConstraints& picks, double weight
);

/// The control points x, a column for each axis, that minimise x^T H x / 2 - right^T x under the
/// constraints. `factor`: of H + weight A^T A.
[[nodiscard]] ControlPoints constrainedFit(
    const BandCholesky<1>& factor,
    const PickConstraints& picks,
    const ControlPoints& right,
    double weight
);

}  // namespace bspline_curve
