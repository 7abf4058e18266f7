// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/cell_integrand.h"
#include "solver/sample_rule.h"

namespace bspline_curve {

/// E_dist (8) and E_ext (5) of a curve, cell by cell: every span is cut exactly where it passes
/// from one cell into the next, so that the integrand is smooth on each piece and the energy
/// C1 in the control points, and the whole curve is checked for lying in the shell. Adds to the
/// terms and, where given, the derivatives; the Hessian holds the second derivative of the barrier,
/// Gauss-Newton for c(I), and the kinks at the walls. False where the curve leaves the shell or the
/// barrier.
[[nodiscard]] bool integrateCells(
    const CurveProblem& problem,
    const SplineSpace& space,
    const ControlPoints& controls,
    const EnergyWeights& weights,
    EnergyTerms& terms,
    EnergyDerivatives* derivatives
);

/// The same at samples (15), (16), as in the paper. False where a sample lies beyond the barrier,
/// or outside of the shell unless EnergyWeights::outsideAllowed is set, which needs
/// CurveProblem::boundary.
[[nodiscard]] bool integrateSamples(
    const CurveProblem& problem,
    const SplineSpace& space,
    const ControlPoints& controls,
    const EnergyWeights& weights,
    const SampleRule& rule,
    EnergyTerms& terms,
    EnergyDerivatives* derivatives
);

}  // namespace bspline_curve
