// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/near_shell.h"
#include "solver/initial_curve.h"
#include "solver/solve_report.h"

#include <memory>
#include <vector>

namespace bspline_curve {

/// A curve, and how it came about.
struct Solution {
    SplineCurve curve;
    SolveReport report;
    /// The shell that the curve lies in, where the problem has none.
    std::shared_ptr<const NearShell> near;
    /// The faces of the whole base that its shadow passes there, in order, ghosts included; one may
    /// come several times.
    std::vector<int> facesPassed;
};

}  // namespace bspline_curve
