// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/curve_ladder.h"

#include "projection/sheet_tracer.h"
#include "solver/initial_curve.h"
#include "solver/obstacles.h"
#include "utility/stopwatch.h"

#include <algorithm>
#include <utility>

namespace bspline_curve {
namespace {

struct LadderConstants {
    /// Between feet, in mean edge lengths: shorter ways than faces are long.
    double stepLength = 0.5;
    /// A tight fit is within so many tolerances of its path.
    double tightDistance = 0.5;
    /// Where it is farther from its feet than so many tolerances, these jump: the path is better,
    /// even where it is farther than one tolerance as well.
    double farthestFit = 10.0;
    /// So many places of a curve tell whether it is far from all of the surface.
    std::size_t places = 64;
};

constexpr LadderConstants kLadder;

// On the surface itself: vertices of the extended one may have moved.
Vec3 positionOn(const PreparedSurface& prepared, const SurfacePoint& point) {
    return prepared.extended()->frame.toUnit(prepared.surface().position(point));
}

SheetTraceStart sheetStartOf(const PreparedSurface& prepared, const CurveProblem& problem) {
    return {
        prepared.surface(),
        *problem.extended,
        problem.picks,
        problem.distanceTolerance,
        kLadder.stepLength * problem.averageEdgeLength
    };
}

bool isClear(const CurveProblem& problem, const CurveDistance& distance) {
    return problem.obstacles == nullptr ||
           std::ranges::none_of(facesPassed(distance.trace), [&](int face) {
               return problem.obstacles->isAvoided(face);
           });
}

// Whether one of some breaks lies farther from all of the surface than a curve may from its sheet:
// measureOnSheet() would find that as well, on its way over many faces.
bool isFarFromAll(
    const PreparedSurface& prepared, const CurveProblem& problem, const SplineCurve& curve
) {
    const ShellFrame& frame = prepared.extended()->frame;
    const double farthest = problem.distanceTolerance * frame.scale;
    const std::vector<double>& breaks = curve.space.breaks();
    const std::size_t stride = breaks.size() / kLadder.places + 1;
    for (std::size_t i = 0; i < breaks.size(); i += stride) {
        const Vec3 position = frame.toUser(curve.space.evaluate(curve.controls, breaks[i]));
        if (prepared.tree().closestPoint(position, farthest).point.face < 0) {
            return true;
        }
    }
    return false;
}

void take(const CurveProblem& problem, CurveDistance distance, Solution& solution) {
    SolveReport& report = solution.report;
    report.maxDistance = distance.largest / problem.averageEdgeLength;
    report.usable = distance.largest < problem.distanceTolerance;
    solution.trace = std::move(distance.trace);
}

}  // namespace

std::optional<Solution> followedOnSheet(
    const PreparedSurface& prepared, const CurveProblem& problem, const Solution& lost
) {
    const auto& [space, controls] = lost.curve;
    if (isFarFromAll(prepared, problem, lost.curve)) {
        return std::nullopt;
    }
    SheetTraceStart traced = sheetStartOf(prepared, problem);
    traced.mostDistance = problem.distanceTolerance;
    CurveDistance distance = measureOnSheet(traced, space, controls);
    if (distance.largest >= problem.distanceTolerance || !isClear(problem, distance)) {
        return std::nullopt;
    }
    Solution found{lost.curve, lost.report, {}};
    take(problem, std::move(distance), found);
    found.report.status = SolveStatus::DistanceReached;
    return found;
}

Solution tightAlong(const PreparedSurface& prepared, CurveProblem problem, InitialPath path) {
    Stopwatch watch;
    std::vector<EdgeCrossing> guide;
    for (InitialPath::Point& point : path.points) {
        guide.push_back({point.parameter, point.point});
        point.position = positionOn(prepared, point.point);
    }
    for (PickConstraint& pick : problem.picks) {
        pick.position = positionOn(prepared, pick.point);
    }
    // Where the path winds through folds, its spans are as short in them as on a straight one.
    problem.options.minimumSpan *= std::min(1.0, problem.chordLength / path.length());
    SheetTraceStart traced = sheetStartOf(prepared, problem);
    traced.guide = guide;
    traced.mostDistance = kLadder.farthestFit * problem.distanceTolerance;
    Solution solution{
        fitLoosely(problem, path, kLadder.tightDistance * problem.distanceTolerance), {}, {}
    };
    const auto& [space, controls] = solution.curve;
    SolveReport& report = solution.report;
    report.status = SolveStatus::TightFit;
    report.knotsFirst = report.knotsLast = static_cast<int>(space.knotVector().size());
    report.seconds.initial = watch.lap();
    CurveDistance distance = measureOnSheet(traced, space, controls);
    const bool isClearWay = isClear(problem, distance);
    if (distance.largest >= problem.distanceTolerance || !isClearWay) {
        CurveDistance ofPath = measureOnPath(traced, space, controls);
        const bool isNear = ofPath.largest < problem.distanceTolerance;
        if (isNear || distance.largest > traced.mostDistance || !isClearWay) {
            distance = std::move(ofPath);
            report.status = isNear ? SolveStatus::TightFit : SolveStatus::ShortestPath;
        }
    }
    take(problem, std::move(distance), solution);
    return solution;
}

}  // namespace bspline_curve
