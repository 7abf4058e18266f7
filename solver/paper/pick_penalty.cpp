// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/paper/pick_penalty.h"

namespace bspline_curve {

double addPickPenalty(
    double chordLength,
    const SplineSpace& space,
    const std::vector<InterpolationRow>& rows,
    const ControlPoints& controls,
    double beta,
    EnergyDerivatives* derivatives
) {
    const double scale = 1.0 / (static_cast<double>(rows.size()) * chordLength * chordLength);
    double energy = 0.0;
    for (const InterpolationRow& row : rows) {
        Vec3 gap = -row.target;
        for (int j = 0; j < space.basisCount(); ++j) {
            gap += row.values[j] * controls.row(space.control(row.span, j)).transpose();
        }
        energy += scale * gap.squaredNorm();
        if (derivatives == nullptr || beta == 0.0) {
            continue;
        }
        for (int j = 0; j < space.basisCount(); ++j) {
            derivatives->gradient.segment<3>(3 * space.control(row.span, j)) +=
                row.values[j] * (2.0 * scale * beta * gap);
            for (int k = 0; k <= j; ++k) {
                // Rounded as in the lower triangle of the whole Hessian.
                const bool wraps = space.control(row.span, j) < space.control(row.span, k);
                const double value =
                    2.0 * scale * beta * row.values[wraps ? j : k] * row.values[wraps ? k : j];
                derivatives->hessian[row.span][blockIndex(j, k)] +=
                    SymmetricMatrix{value, 0.0, 0.0, value, 0.0, value};
            }
        }
    }
    return energy;
}

}  // namespace bspline_curve
