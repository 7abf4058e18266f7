// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/curve_problem.h"

namespace bspline_curve {

/// A shell to trace a curve through, and the point of the surface near which the curve starts.
/// Refers to what it is made from.
struct TraceStart {
    const Shell& shell;
    const ExtendedSurface& extended;
    SurfacePoint start;
    Vec3 startPosition;
};

/// The shell of a problem, which it must have.
[[nodiscard]] inline TraceStart traceStartOf(const CurveProblem& problem) {
    const PickConstraint& first = problem.picks.front();
    return {*problem.shell, *problem.extended, first.point, first.position};
}

}  // namespace bspline_curve
