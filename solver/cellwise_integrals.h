// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/energy.h"
#include "solver/internal_energy.h"
#include "solver/quadrature.h"

#include <vector>

namespace bspline_curve {

/// The terms of (7) of splines of one space in a shell, with their derivatives.
/// `segments`: E_dist and E_ext at two samples on each of so many parts of a span; 0: cell by cell,
/// exactly.
class CellwiseIntegrals {
public:
    CellwiseIntegrals(
        const CurveProblem& problem,
        const SplineSpace& space,
        const std::vector<InterpolationRow>& rows,
        int segments
    );

    /// See InternalEnergy::setDirections.
    void setDirections(const BendingDirections& directions) { internal_.setDirections(directions); }

    void setSegments(int segments) { segments_ = segments; }

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
    const std::vector<InterpolationRow>& rows_;
    InternalEnergy internal_;
    int segments_;
};

}  // namespace bspline_curve
