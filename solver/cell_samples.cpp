// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/quadrature.h"
#include "solver/sample_walker.h"

#include <algorithm>
#include <optional>

namespace bspline_curve {

bool integrateSamples(
    const CurveProblem& problem,
    const SplineSpace& space,
    const ControlPoints& controls,
    const EnergyWeights& weights,
    const SampleRule& rule,
    EnergyTerms& terms,
    EnergyDerivatives* derivatives
) {
    const double scale = weights.outsideAllowed ? problem.options.paper.heightScale : 1.0;
    bool belowBarrier = true;
    std::optional<DerivativeCollector> collector;
    if (derivatives != nullptr) {
        collector.emplace(space, *derivatives);
    }
    const auto visit = [&](const SampleWalker& walker,
                           const PolynomialCurve& /*curve*/,
                           int span,
                           double tau,
                           double weight) {
        if (walker.outside() && !weights.outsideAllowed) {
            return false;
        }
        const CellIntegrand integrand(problem, weights, walker.cell(), scale);
        // Outside, the terms are those of the boundary point and do not change with the sample.
        if (!collector || walker.outside()) {
            belowBarrier &= integrand.add(walker.position(), weight, terms);
            return true;
        }
        PointDerivatives point;
        belowBarrier &= integrand.add(walker.position(), weight, terms, point);
        collector->add(span, tau, point);
        return true;
    };
    const bool isWhole = walkSamples(problem, space, controls, rule, visit);
    if (collector) {
        collector->finish();
    }
    return isWhole && belowBarrier;
}

double largestSampledHeight(
    const CurveProblem& problem,
    const SplineSpace& space,
    const ControlPoints& controls,
    const SampleRule& rule
) {
    double largest = 0.0;
    const auto visit = [&](const SampleWalker& walker, const auto&...) {
        largest = std::max(largest, walker.relativeHeight());
        return true;
    };
    (void)walkSamples(problem, space, controls, rule, visit);
    return largest;
}

}  // namespace bspline_curve
