// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/solution.h"

#include <optional>

namespace bspline_curve {

/// Share of the progress at most that relax() reports; what is left is for a curve that it does not
/// find.
inline constexpr double kRelaxedShare = 0.5;

/// A spline that nearly passes the picks, and the weight of the distance that it was relaxed with.
struct RelaxationStart {
    SplineCurve curve;
    double alpha = 0.0;
};

/// Alg. 1 of the paper with energies at samples (FootEnergy): from a fit to the guide, a few Newton
/// steps, then a larger weight of the distance and knots where a span would gain by bulging, again
/// and again; at last the whole curve is traced through the shell, and spans that leave the
/// tolerance are halved. Hardly depends on the resolution of the surface.
///
/// `start`: where to begin, in place of a fit to the guide.
///
/// Nothing where that is not for this curve (see SolverOptions::quadrature), or where the curve
/// does not come to lie in the shell and within the tolerance: solve() then finds one with every
/// iterate inside. Throws Cancelled.
[[nodiscard]] std::optional<Solution> relax(
    const CurveProblem& problem, const GuidePath& guide, std::optional<RelaxationStart> start = {}
);

}  // namespace bspline_curve
