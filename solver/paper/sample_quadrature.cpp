// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/paper/sample_walker.h"
#include "solver/quadrature.h"

#include <array>
#include <optional>

namespace bspline_curve {
namespace {

// eta of the paper's Sect. 4.2.
constexpr double kHeightScale = 0.99;
}  // namespace

bool integrateSamples(
    const CurveProblem& problem,
    const SplineSpace& space,
    const ControlPoints& controls,
    const EnergyWeights& weights,
    int segments,
    EnergyTerms& terms,
    EnergyDerivatives* derivatives
) {
    SampleWalker walker(problem, space, controls);
    bool belowBarrier = true;
    std::optional<DerivativeCollector> collector;
    if (derivatives != nullptr) {
        collector.emplace(space, *derivatives);
    }
    for (int span = 0; span < space.spanCount(); ++span) {
        const PolynomialCurve curve = space.polynomial(controls, span);
        const double weight = 0.5 * space.spanLength(span) / segments;
        for (int i = 0; i < 2 * segments; ++i) {
            const double tau = sampleParameter(i, segments);
            walker.moveTo(curve.at(tau));
            if (walker.outside() && !weights.outsideAllowed) {
                return false;
            }
            const double scale = weights.outsideAllowed ? kHeightScale : 1.0;
            const CellIntegrand integrand(problem, weights, walker.cell(), scale);
            // Outside, the terms are those of the boundary point and do not change with the sample.
            if (!collector || walker.outside()) {
                belowBarrier &= integrand.add(walker.position(), weight, terms);
                continue;
            }
            PointDerivatives point;
            belowBarrier &= integrand.add(walker.position(), weight, terms, point);
            collector->add(span, tau, point);
        }
    }
    if (collector) {
        collector->finish();
    }
    return belowBarrier;
}

}  // namespace bspline_curve
