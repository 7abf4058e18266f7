// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/near_shell.h"
#include "solver/initial_curve.h"
#include "solver/shadow_curve.h"
#include "solver/solve_report.h"

#include <memory>
#include <optional>
#include <vector>

namespace bspline_curve {

/// A curve, and how it came about.
struct Solution {
    SplineCurve curve;
    SolveReport report;
    /// The shell that the curve lies in, where the problem has none.
    std::shared_ptr<const NearShell> near;
    /// Of the curve, where one was left over: always from relax().
    std::optional<ShadowTrace> trace;
};

/// The faces that a curve with a trace passes, as ShadowTrace::faces().
[[nodiscard]] std::vector<int> facesPassed(const Solution& solution, const CurveProblem& problem);

}  // namespace bspline_curve
