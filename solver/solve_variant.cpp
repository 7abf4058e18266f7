// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/solve_variant.h"

#include "solver/internal_energy.h"

#include <stdexcept>

namespace bspline_curve {

std::optional<SplineCurve> SolveVariant::firstCurve(
    const CurveProblem& problem, const InitialPath& initialPath
) const {
    return fitInitialPath(problem, initialPath);
}

std::vector<SplineSpace::BasisMatrix> SolveVariant::bendingProducts(
    const CurveProblem& problem, const SplineSpace& space, const SampleRule& /*rule*/
) const {
    std::vector<SplineSpace::BasisMatrix> products;
    products.reserve(space.spanCount());
    for (int span = 0; span < space.spanCount(); ++span) {
        products.push_back(ambientProducts(problem, space, span));
    }
    return products;
}

std::vector<std::unique_ptr<SplineTerm>> SolveVariant::moreTerms(
    const CurveProblem& /*problem*/,
    const SplineSpace& /*space*/,
    const std::vector<InterpolationRow>& /*rows*/
) const {
    return {};
}

std::unique_ptr<RoundVariant> SolveVariant::rounds(const CurveProblem& /*problem*/) const {
    return std::make_unique<RoundVariant>();
}

bool needsVariant(const SolverOptions& options) {
    return options.quadrature == Quadrature::Samples ||
           options.initialCurve != InitialCurve::GeodesicFit ||
           options.barrierWidth != BarrierWidth::Full ||
           options.distanceWeight != DistanceWeight::Schedule ||
           options.interpolation != Interpolation::Constraint ||
           options.knotRule != KnotRule::EnergyAndDistance;
}

const SolveVariant& variantOf(const CurveProblem& problem) {
    static const SolveVariant own;
    if (problem.variant != nullptr) {
        return *problem.variant;
    }
    if (needsVariant(problem.options)) {
        throw std::logic_error("options of a variant of the solver that is not plugged in");
    }
    return own;
}

}  // namespace bspline_curve
