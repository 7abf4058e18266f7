// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/path_spline.h"

#include "bspline_curve/progress.h"
#include "design/curve_ladder.h"
#include "projection/curve_distance.h"
#include "projection/fibre_tracer.h"
#include "solver/knot_insertion.h"
#include "solver/problem_traces.h"
#include "utility/stopwatch.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace bspline_curve {
namespace {

/// Splines along one path, each with more knots where the one before is too far from the surface.
constexpr int kMostSplines = 12;

}  // namespace

std::optional<Solution> splineAlong(
    const PreparedSurface& prepared,
    const CurveProblem& problem,
    const InitialPath& path,
    double distance
) {
    Stopwatch watch;
    Solution solution{fitLoosely(problem, path, distance), {}, {}};
    SolveReport& result = solution.report;
    result.status = SolveStatus::Converged;
    result.knotsFirst = static_cast<int>(solution.curve.space.knotVector().size());
    for (int i = 0; i < kMostSplines; ++i) {
        report(problem.progress, static_cast<double>(i) / kMostSplines, "fitting a spline");
        const auto& [space, controls] = solution.curve;
        CurveDistance measured = measureAlongFibres(fibreStartOf(problem), space, controls);
        if (measured.largest < problem.distanceTolerance) {
            result.usable = true;
            result.maxDistance = measured.largest / problem.averageEdgeLength;
            result.knotsLast = static_cast<int>(space.knotVector().size());
            result.seconds.initial = watch.lap();
            solution.trace = std::move(measured.trace);
            return solution;
        }
        std::vector<double> finer = halveSpans(
            space, farSpans(measured, problem.distanceTolerance), problem.options.minimumSpan
        );
        if (finer.size() == space.breaks().size()) {
            break;
        }
        solution.curve = fitLoosely(problem, path, distance, std::move(finer));
    }
    // Where fibres cross.
    result.knotsLast = static_cast<int>(solution.curve.space.knotVector().size());
    result.seconds.initial = watch.lap();
    return followedOnSheet(prepared, problem, solution);
}

}  // namespace bspline_curve
