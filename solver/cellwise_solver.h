// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/solution.h"
#include "solver/stop_rule.h"

#include <optional>

namespace bspline_curve {

/// A curve along the initial path as solveInShell() finds it, from makeFirstCurve(). Nothing where
/// no first spline along the initial path stays in the shell. Throws Cancelled.
[[nodiscard]] std::optional<Solution> solveCellwise(
    const CurveProblem& problem, const InitialPath& initialPath
);

/// Alg. 1 of the paper: from a first spline along the initial path, minimise, raise the weights,
/// insert knots, until the curve is near enough to the surface and more knots no longer change it;
/// every iterate lies in the shell. Throws Cancelled.
[[nodiscard]] Solution solveInShell(
    const CurveProblem& problem, const InitialPath& initialPath, SplineCurve first
);

}  // namespace bspline_curve
