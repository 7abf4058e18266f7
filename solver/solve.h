// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/solution.h"

#include <optional>

namespace bspline_curve {

/// A curve along the guide as solveInShell() finds it, from makeFirstCurve(). Nothing where no
/// first spline along the guide stays in the shell. Throws Cancelled.
[[nodiscard]] std::optional<Solution> solveByCells(
    const CurveProblem& problem, const GuidePath& guide
);

/// Alg. 1 of the paper: from a first spline along the guide, minimise, raise the weights, insert
/// knots, until the curve is near enough to the surface and more knots no longer change it; every
/// iterate lies in the shell. Throws Cancelled.
[[nodiscard]] Solution solveInShell(
    const CurveProblem& problem, const GuidePath& guide, SplineCurve first
);

}  // namespace bspline_curve
