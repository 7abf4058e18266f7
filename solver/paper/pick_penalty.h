// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/energy_derivatives.h"
#include "spline/spline_system.h"

#include <vector>

namespace bspline_curve {

/// E_fit (9): the mean squared distance of the spline from the picks, relative to `chordLength`.
/// Adds the derivatives of beta times that, where asked for.
[[nodiscard]] double addPickPenalty(
    double chordLength,
    const SplineSpace& space,
    const std::vector<InterpolationRow>& rows,
    const ControlPoints& controls,
    double beta,
    EnergyDerivatives* derivatives
);

}  // namespace bspline_curve
