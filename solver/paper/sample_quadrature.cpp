// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/paper/sample_walker.h"
#include "solver/quadrature.h"

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
    SampleWalker walker(problem, space, controls);
    const double scale = weights.outsideAllowed ? problem.options.paper.heightScale : 1.0;
    bool belowBarrier = true;
    std::optional<DerivativeCollector> collector;
    if (derivatives != nullptr) {
        collector.emplace(space, *derivatives);
    }
    int current = -1;
    PolynomialCurve curve;
    const bool isWhole = forEachSample(space, rule, [&](int span, double tau, double weight) {
        if (span != current) {
            current = span;
            curve = space.polynomial(controls, span);
        }
        walker.moveTo(curve.at(tau));
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
    });
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
    SampleWalker walker(problem, space, controls);
    double largest = 0.0;
    int current = -1;
    PolynomialCurve curve;
    (void)forEachSample(space, rule, [&](int span, double tau, double) {
        if (span != current) {
            current = span;
            curve = space.polynomial(controls, span);
        }
        walker.moveTo(curve.at(tau));
        largest = std::max(largest, walker.relativeHeight());
        return true;
    });
    return largest;
}

}  // namespace bspline_curve
