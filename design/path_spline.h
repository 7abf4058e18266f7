// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "design/prepared_surface.h"
#include "solver/curve_problem.h"
#include "solver/initial_curve.h"
#include "solver/solution.h"

#include <optional>

namespace bspline_curve {

/// A spline within a distance of a path on the surface, by least squares with few knots: spans are
/// halved where it is farther from the path, or from the surface than the problem's tolerance.
/// `distance`: in the shell's frame. The problem has no shell and no obstacles, and the path's ends
/// for picks, or its start where it is closed. O(n log n). Nothing where no such spline is found.
/// Throws Cancelled.
[[nodiscard]] std::optional<Solution> splineAlong(
    const PreparedSurface& prepared,
    const CurveProblem& problem,
    const InitialPath& path,
    double distance
);

}  // namespace bspline_curve
