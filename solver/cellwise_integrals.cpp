// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/cellwise_integrals.h"

#include "solver/solve_variant.h"

namespace bspline_curve {

CellwiseIntegrals::CellwiseIntegrals(
    const CurveProblem& problem,
    const SplineSpace& space,
    const std::vector<InterpolationRow>& rows,
    const SampleRule& rule
)
    : problem_(problem),
      space_(space),
      internal_(problem, space, rule),
      moreTerms_(variantOf(problem).moreTerms(problem, space, rows)),
      rule_(rule) {}

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
    for (const std::unique_ptr<SplineTerm>& term : moreTerms_) {
        term->add(controls, weights, value.terms, derivatives);
    }
    value.total = PointTerms::sum(value.terms, problem_, weights);
    value.scale = PointTerms::scale(value.terms, problem_, weights, 0.0);
    return value;
}

}  // namespace bspline_curve
