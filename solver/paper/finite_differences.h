// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/curve_problem.h"
#include "solver/sample_rule.h"
#include "spline/spline_space.h"

#include <vector>

namespace bspline_curve {

/// E_int as in (14), for each span as ambientProducts() gives it: at samples, with P' and P'' by
/// central differences over half a segment to either side. Differences stay within the span of
/// their sample, so that they couple no more control points than the span has; where half a segment
/// does not fit, they take what fits. Of cubic spans P'' is exact, P' off by P''' h^2 / 6.
[[nodiscard]] std::vector<SplineSpace::BasisMatrix> differenceProducts(
    const CurveProblem& problem, const SplineSpace& space, const SampleRule& rule
);

}  // namespace bspline_curve
