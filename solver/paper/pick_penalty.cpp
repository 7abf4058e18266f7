// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/paper/pick_penalty.h"

namespace bspline_curve {

void PickPenalty::add(
    const ControlPoints& controls,
    const EnergyWeights& weights,
    EnergyTerms& terms,
    EnergyDerivatives* derivatives
) const {
    const double beta = weights.beta;
    const double scale = 1.0 / (static_cast<double>(rows_.size()) * chordLength_ * chordLength_);
    for (const InterpolationRow& row : rows_) {
        Vec3 gap = -row.target;
        for (int j = 0; j < space_.basisCount(); ++j) {
            gap += row.values[j] * controls.row(space_.control(row.span, j)).transpose();
        }
        terms.fit += scale * gap.squaredNorm();
        if (derivatives == nullptr || beta == 0.0) {
            continue;
        }
        for (int j = 0; j < space_.basisCount(); ++j) {
            derivatives->gradient.segment<3>(3 * space_.control(row.span, j)) +=
                row.values[j] * (2.0 * scale * beta * gap);
            for (int k = 0; k <= j; ++k) {
                // Rounded as in the lower triangle of the whole Hessian.
                const bool wraps = space_.control(row.span, j) < space_.control(row.span, k);
                const double value =
                    2.0 * scale * beta * row.values[wraps ? j : k] * row.values[wraps ? k : j];
                derivatives->hessian[row.span][blockIndex(j, k)] +=
                    SymmetricMatrix{value, 0.0, 0.0, value, 0.0, value};
            }
        }
    }
}

}  // namespace bspline_curve
