// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/spline_term.h"
#include "spline/spline_system.h"

#include <vector>

namespace bspline_curve {

/// E_fit (9): the mean squared distance of the spline from the picks, relative to the chord length.
class PickPenalty final : public SplineTerm {
public:
    /// Refers to the space and the rows.
    PickPenalty(
        double chordLength, const SplineSpace& space, const std::vector<InterpolationRow>& rows
    )
        : chordLength_(chordLength), space_(space), rows_(rows) {}

    /// Its weight is EnergyWeights::beta.
    void add(
        const ControlPoints& controls,
        const EnergyWeights& weights,
        EnergyTerms& terms,
        EnergyDerivatives* derivatives
    ) const override;

private:
    double chordLength_;
    const SplineSpace& space_;
    const std::vector<InterpolationRow>& rows_;
};

}  // namespace bspline_curve
