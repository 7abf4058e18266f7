// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/cellwise_integrals.h"

#include "solver/paper/pick_penalty.h"

#include <cmath>

namespace bspline_curve {

CellwiseIntegrals::CellwiseIntegrals(
    const CurveProblem& problem,
    const SplineSpace& space,
    const std::vector<InterpolationRow>& rows,
    const SampleRule& rule
)
    : problem_(problem), space_(space), rows_(rows), internal_(problem, space, rule), rule_(rule) {}

EnergyValue CellwiseIntegrals::evaluate(
    const ControlPoints& controls, const EnergyWeights& weights, EnergyDerivatives* derivatives
) const {
    EnergyValue value;
    value.inside =
        rule_.isExact()
            ? integrateCells(problem_, space_, controls, weights, value.terms, derivatives)
            : integrateSamples(
                  problem_, space_, controls, weights, rule_, value.terms, derivatives
              );
    if (!value.inside) {
        return value;
    }
    value.terms.internal = internal_.add(controls, derivatives);
    value.terms.fit =
        addPickPenalty(problem_.chordLength, space_, rows_, controls, weights.beta, derivatives);
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

}  // namespace bspline_curve
