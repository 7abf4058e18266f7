// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "projection/fibre_tracer.h"
#include "projection/trace_start.h"
#include "solver/curve_problem.h"

namespace bspline_curve {

/// To trace a curve through the shell of a problem, which it must have.
[[nodiscard]] inline TraceStart traceStartOf(const CurveProblem& problem) {
    const PickConstraint& first = problem.picks.front();
    return {*problem.shell, *problem.extended, first.point, first.position};
}

/// To follow a curve along the fibres of a problem.
[[nodiscard]] inline FibreTraceStart fibreStartOf(const CurveProblem& problem) {
    return {*problem.extended, problem.picks, problem.distanceTolerance, problem.side};
}

}  // namespace bspline_curve
