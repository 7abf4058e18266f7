// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/energy.h"
#include "solver/internal_energy.h"
#include "solver/quadrature.h"
#include "solver/spline_term.h"

#include <memory>
#include <vector>

namespace bspline_curve {

/// The terms of (7) of splines of one space in a shell, with their derivatives.
/// `rule`: where E_dist and E_ext are sampled.
class CellwiseIntegrals {
public:
    CellwiseIntegrals(
        const CurveProblem& problem,
        const SplineSpace& space,
        const std::vector<InterpolationRow>& rows,
        const SampleRule& rule
    );

    /// See InternalEnergy::setDirections.
    void setDirections(const BendingDirections& directions) { internal_.setDirections(directions); }

    /// Another one of spans.
    void setRule(const SampleRule& rule) { rule_ = rule; }

    [[nodiscard]] EnergyValue evaluate(
        const ControlPoints& controls, const EnergyWeights& weights
    ) const {
        return evaluate(controls, weights, nullptr);
    }

    /// Sets the derivatives as well.
    [[nodiscard]] EnergyValue evaluate(
        const ControlPoints& controls, const EnergyWeights& weights, EnergyDerivatives& derivatives
    ) const {
        derivatives.reset(space_);
        return evaluate(controls, weights, &derivatives);
    }

private:
    [[nodiscard]] EnergyValue evaluate(
        const ControlPoints& controls, const EnergyWeights& weights, EnergyDerivatives* derivatives
    ) const;

    const CurveProblem& problem_;
    const SplineSpace& space_;
    InternalEnergy internal_;
    std::vector<std::unique_ptr<SplineTerm>> moreTerms_;  // of the problem's variant
    SampleRule rule_;
};

}  // namespace bspline_curve
