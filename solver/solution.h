// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/initial_curve.h"
#include "solver/solve_report.h"

namespace bspline_curve {

/// A curve, and how it came about.
struct Solution {
    SplineCurve curve;
    SolveReport report;
};

}  // namespace bspline_curve
