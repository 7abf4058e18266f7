// SPDX-License-Identifier: GPL-3.0-or-later
#include "spline/constrained_fit.h"

#include <utility>

namespace bspline_curve {

void addProducts(
    BandCholesky<1>& matrix,
    const SplineSpace& space,
    int span,
    const SplineSpace::BasisMatrix& products
) {
    for (int j = 0; j < space.basisCount(); ++j) {
        for (int i = 0; i < space.basisCount(); ++i) {
            const int row = space.control(span, i);
            const int column = space.control(span, j);
            if (row >= column) {
                matrix.add(row, column, &products(i, j), 1);
            }
        }
    }
}

void addProducts(
    BandCholesky<1>& matrix, const SplineSpace& space, const PickConstraints& picks, double weight
) {
    for (const InterpolationRow& row : picks.rows()) {
        SplineSpace::BasisMatrix products = SplineSpace::BasisMatrix::Zero();
        for (int j = 0; j < space.basisCount(); ++j) {
            for (int k = 0; k < space.basisCount(); ++k) {
                products(j, k) = weight * row.values[j] * row.values[k];
            }
        }
        addProducts(matrix, space, row.span, products);
    }
}

ControlPoints constrainedFit(
    const BandCholesky<1>& factor,
    const PickConstraints& picks,
    const ControlPoints& right,
    double weight
) {
    const Eigen::Index count = right.rows();
    const Eigen::VectorXd flat = picks.minimiser(
        Eigen::Map<const Eigen::VectorXd>(right.data(), right.size()),
        picks.residual(ControlPoints::Zero(count, 3)),
        weight,
        [&](Eigen::VectorXd&& pulled) {
            Eigen::Map<ControlPoints> axes(pulled.data(), count, 3);
            for (int axis = 0; axis < 3; ++axis) {
                axes.col(axis) = factor.solve(axes.col(axis));
            }
            return std::move(pulled);
        }
    );
    return Eigen::Map<const ControlPoints>(flat.data(), count, 3);
}

}  // namespace bspline_curve
