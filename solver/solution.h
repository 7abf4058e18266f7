// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/report.h"
#include "projection/curve_trace.h"
#include "solver/initial_curve.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace bspline_curve {

/// A curve, and how it came about.
struct Solution {
    SplineCurve curve;
    SolveReport report;
    /// Of the curve, where one was left over: always from solveSampled().
    std::optional<CurveTrace> trace;
    std::int64_t work = 0;  ///< what it has cost, see Energy::work()
};

/// The faces that a curve with a trace passes, ghosts included; one may come several times.
[[nodiscard]] std::vector<int> facesPassed(const Solution& solution);

}  // namespace bspline_curve
