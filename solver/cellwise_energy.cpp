// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/cellwise_energy.h"

#include <cmath>

namespace bspline_curve {
CellwiseEnergy::CellwiseEnergy(
    const CurveProblem& problem,
    const SplineSpace& space,
    const std::vector<InterpolationRow>& rows,
    int segments
)
    : problem_(problem),
      space_(space),
      rows_(rows),
      internal_(problem, space),
      segments_(segments) {}

EnergyValue CellwiseEnergy::evaluate(
    const ControlPoints& controls, const EnergyWeights& weights, EnergyDerivatives* derivatives
) const {
    EnergyValue value;
    value.inside =
        segments_ == 0
            ? integrateCells(problem_, space_, controls, weights, value.terms, derivatives)
            : integrateSamples(
                  problem_, space_, controls, weights, segments_, value.terms, derivatives
              );
    if (!value.inside) {
        return value;
    }
    value.terms.internal = internal_.add(controls, derivatives);
    value.terms.fit = addFit(controls, weights, derivatives);
    const double field = fieldWeight(problem_) * value.terms.external;
    const double others = value.terms.internal + weights.alpha * value.terms.distance +
                          weights.beta * value.terms.fit +
                          weights.avoidance * value.terms.avoidance;
    value.total = others + field;
    const double aboveLeast =
        fieldWeight(problem_) * (value.terms.external - problem_.fieldCosts.least);
    value.scale = others + kFieldShare * std::abs(aboveLeast);
    return value;
}

double CellwiseEnergy::addFit(
    const ControlPoints& controls, const EnergyWeights& weights, EnergyDerivatives* derivatives
) const {
    const double scale =
        1.0 / (static_cast<double>(rows_.size()) * problem_.chordLength * problem_.chordLength);
    double energy = 0.0;
    for (const InterpolationRow& row : rows_) {
        Vec3 gap = -row.target;
        for (int j = 0; j < space_.basisCount(); ++j) {
            gap += row.values[j] * controls.row(space_.control(row.span, j)).transpose();
        }
        energy += scale * gap.squaredNorm();
        if (derivatives != nullptr && weights.beta > 0.0) {
            addGradient(
                derivatives->gradient,
                space_,
                row.span,
                row.values,
                2.0 * scale * weights.beta * gap
            );
            for (int axis = 0; axis < 3; ++axis) {
                addRankOne(
                    derivatives->hessian[row.span],
                    row.values,
                    Vec3::Unit(axis),
                    2.0 * scale * weights.beta,
                    space_.basisCount()
                );
            }
        }
    }
    return energy;
}

}  // namespace bspline_curve
