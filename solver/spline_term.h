// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/report.h"
#include "solver/energy_derivatives.h"
#include "solver/energy_weights.h"

namespace bspline_curve {

/// A term of (7) that depends on the control points at once, and not point by point.
class SplineTerm {
public:
    SplineTerm() = default;
    SplineTerm(const SplineTerm&) = delete;
    SplineTerm& operator=(const SplineTerm&) = delete;
    virtual ~SplineTerm() = default;

    /// Adds its value without its weight to the terms, and its weighted derivatives where asked
    /// for.
    virtual void add(
        const ControlPoints& controls,
        const EnergyWeights& weights,
        EnergyTerms& terms,
        EnergyDerivatives* derivatives
    ) const = 0;
};

}  // namespace bspline_curve
