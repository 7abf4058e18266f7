// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "design/initial_path.h"
#include "design/prepared_surface.h"
#include "solver/curve_problem.h"
#include "solver/solution.h"

#include <optional>

namespace bspline_curve {

// What is left where no relaxed spline can be followed along the fibres: from the best to what
// there always is.

/// A curve that was relaxed but could not be followed along the fibres, followed by the nearest
/// points of its sheet (see measureOnSheet()). Nothing where it is farther from them than the
/// tolerance, or passes what it is to avoid.
[[nodiscard]] std::optional<Solution> followedOnSheet(
    const PreparedSurface& prepared, const CurveProblem& problem, const Solution& lost
);

/// A spline that follows the path closely, with a trace by the nearest points of the path's sheet;
/// where these are far, or in what it is to avoid, by the points of the path itself. Usable where
/// it is within the tolerance of them. SolveStatus::ShortestPath where the path itself is not, else
/// SolveStatus::TightFit. `path`: consecutive points share a face.
[[nodiscard]] Solution tightAlong(
    const PreparedSurface& prepared, CurveProblem problem, InitialPath path
);

}  // namespace bspline_curve
