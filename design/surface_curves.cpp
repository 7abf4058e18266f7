// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/surface_curves.h"

#include "bspline_curve/error.h"
#include "design/curve_solver.h"
#include "design/detours.h"
#include "design/spline_data.h"
#include "design/strict_polyline.h"
#include "projection/fibre_tracer.h"
#include "projection/projected_curve.h"
#include "solver/obstacles.h"
#include "solver/problem_traces.h"
#include "surface/error_messages.h"
#include "surface/field_on_surface.h"
#include "surface/picks.h"
#include "surface/strict_line.h"
#include "surface/surface_point.h"
#include "utility/index_sets.h"
#include "utility/report_progress.h"
#include "utility/sparse_map.h"
#include "utility/stopwatch.h"
#include "utility/worker_task.h"
#include "utility/worker_thread.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

namespace bspline_curve {
namespace {

// What the curve avoids is certain only where every iterate is checked as a whole.
void requireExactAvoidance(const SolverOptions& options) {
    const auto require = [](bool isExact, const std::string& option, const std::string& needed) {
        if (!isExact) {
            throw InputError(
                InputErrorCode::BadOption,
                option + " cannot keep a curve out of the faces to avoid: use " + needed
            );
        }
    };
    require(options.quadrature != Quadrature::Samples, "quadrature = \"samples\"", "\"cells\"");
    require(
        options.initialCurve == InitialCurve::GeodesicFit,
        "initial_curve = \"control-polygon\"",
        "\"geodesic-fit\""
    );
    require(
        options.interpolation == Interpolation::Constraint,
        "interpolation = \"penalty\"",
        "\"constraint\""
    );
}

// The promise itself, on the result: no vertex and no segment in a face to avoid.
void requireClear(const Surface& surface, const SurfacePolyline& line, const Obstacles& obstacles) {
    const auto freeFacesHolding = [&](const SurfacePoint& point) {
        std::vector<int> faces = facesHolding(surface, point);
        std::erase_if(faces, [&](int f) { return obstacles.isAvoided(f); });
        return faces;
    };
    std::vector<int> before = freeFacesHolding(line.surfacePoints.back());
    for (std::size_t i = 0; i < line.surfacePoints.size(); ++i) {
        std::vector<int> here = freeFacesHolding(line.surfacePoints[i]);
        std::vector<int> common;
        std::ranges::set_intersection(before, here, std::back_inserter(common));
        const bool hasSegment = i > 0 || line.closed;
        if (obstacles.isAvoided(line.surfacePoints[i].face) || (hasSegment && common.empty())) {
            throw std::logic_error("the curve enters a face that it avoids");
        }
        before.swap(here);
    }
}

void refuseAvoidedPicks(
    const Surface& surface, const Obstacles& obstacles, const LocatedPicks& located
) {
    const auto refuse = [](std::size_t pick, int face, const std::string& what) {
        throw InputError(
            InputErrorCode::PickAvoided,
            describePicks({static_cast<std::int64_t>(pick)}) + " lies in face " +
                std::to_string(face) + what + ": move the pick, or avoid fewer faces",
            {static_cast<std::int64_t>(pick)}
        );
    };
    for (std::size_t i = 0; i < located.pointOf.size(); ++i) {
        const SurfacePoint& pick = located.points[located.pointOf[i]];
        for (const int f : facesHolding(surface, pick)) {
            if (obstacles.isAvoided(f)) {
                refuse(i, f, ", which the curve is to avoid");
            }
        }
        if (obstacles.closeness(pick) >= 1.0) {
            refuse(i, pick.face, ", all of whose neighbours the curve is to avoid");
        }
    }
}

// Says in which shell the curve was drawn, or how many faces its fibres met.
void describeShell(const CurveProblem& problem, const Solution& solution, Curve& curve) {
    if (problem.shell != nullptr) {
        curve.shell =
            problem.shell->isFullResolution() ? ShellKind::FullResolution : ShellKind::Simplified;
        curve.prisms = problem.shell->prismCount();
        return;
    }
    SparseMap<char> faces;
    for (const int face : facesPassed(solution)) {
        faces.at(face, 1);
    }
    curve.facesPassed = static_cast<int>(faces.size());
}

// `trace`: of this spline, in the problem's shell or along the fibres; none: of the cells.
SurfacePolyline polylineOf(
    const Surface& surface,
    const CurveProblem& problem,
    const SplineCurve& spline,
    std::optional<CurveTrace> trace,
    const SamplingOptions& sampling
) {
    const auto& [space, controls] = spline;
    if (problem.shell != nullptr && !problem.shell->isFullResolution()) {
        // The fibres of a simplified shell are oblique to the surface, so a spline that is smooth
        // and within its tolerance has a shadow along them that is less smooth.
        CurveDistance fine = measureAlongFibres(fibreStartOf(problem), space, controls);
        // Other fibres may lead into what the curve avoids.
        const auto isAvoided = [&](int f) { return problem.obstacles->isAvoided(f); };
        if (std::isfinite(fine.largest) &&
            (problem.obstacles == nullptr ||
             std::ranges::none_of(facesPassed(fine.trace), isAvoided))) {
            trace = std::move(fine.trace);
        }
    }
    if (!trace) {
        trace = traceCells(traceStartOf(problem), space, controls);
    }
    if (!progressOf(*trace).isWhole) {
        throw std::logic_error("the polyline was asked of a spline that leaves its shell");
    }
    const ProjectedCurve shadow(
        *problem.extended, problem.shell, space, controls, std::move(*trace)
    );
    return makeStrictPolyline(surface, problem, FairedShadow(problem, shadow), sampling);
}

// Least distance of a vertex of the polyline to the faces of a region.
double clearanceOf(const SurfacePolyline& line, const Surface& surface, const Region& region) {
    std::vector<Triangle> avoided;
    for (const int f : region) {
        avoided.push_back(surface.faces()[f]);
    }
    const TriangleTree tree(surface.vertices(), avoided);
    double least = std::numeric_limits<double>::infinity();
    for (const Vec3& point : line.points) {
        least = std::min(least, std::sqrt(tree.closestPoint(point).squaredDistance));
    }
    return least;
}

// The part of a curve whose polyline is farther from its spline than the tolerance.
std::optional<FarPart> farPartOf(
    const CurveProblem& problem, const SplineCurve& spline, const SurfacePolyline& line
) {
    const ShellFrame& frame = problem.extended->frame;
    std::optional<FarPart> part;
    for (std::size_t i = 0; i < line.points.size(); ++i) {
        const double t = line.parameters[i];
        const Vec3 position = spline.space.evaluate(spline.controls, t);
        if ((position - frame.toUnit(line.points[i])).norm() < problem.distanceTolerance) {
            continue;
        }
        if (!part) {
            part.emplace();
            part->from = t;
        }
        part->to = t;
        part->faces.push_back(line.surfacePoints[i].face);
    }
    if (part) {
        sortUnique(part->faces);
    }
    return part;
}

Curve curveOf(const Surface& surface, Solved& solved, const SamplingOptions& sampling) {
    auto& [problem, solution] = solved;
    Curve curve;
    describeShell(problem, solution, curve);
    curve.polyline =
        polylineOf(surface, problem, solution.curve, std::move(solution.trace), sampling);
    curve.spline = splineDataOf(solution.curve, problem.extended->frame, problem.picks);
    curve.report = solution.report;
    if (!curve.report.usable) {
        curve.report.farPart = farPartOf(problem, solution.curve, curve.polyline);
    }
    return curve;
}

/// `numbers`: of the picks, as they were asked for.
void reportDetour(const PreparedSurface& prepared, std::span<const int> numbers, Curve& curve) {
    if (std::optional<Detour> detour = worstDetour(prepared, curve.polyline)) {
        detour->from = numbers[detour->from];
        detour->to = numbers[detour->to];
        curve.report.detours.push_back(*detour);
    }
}

/// Gives each pick as given its vertex and parameter, where some are one; those at the end that
/// coincide with the first of a closed curve have t = 1.
void giveRepeatedPicks(const LocatedPicks& located, Curve& curve) {
    const std::vector<int> vertices = std::move(curve.polyline.picks);
    const std::vector<double> parameters = std::move(curve.spline.pickParameters);
    curve.polyline.picks.clear();
    curve.spline.pickParameters.clear();
    int before = 0;
    for (const int point : located.pointOf) {
        curve.polyline.picks.push_back(vertices[point]);
        curve.spline.pickParameters.push_back(point < before ? 1.0 : parameters[point]);
        before = std::max(before, point);
    }
}

}  // namespace

Curve SurfaceCurves::design(const CurveTask& task, const Progress& progress) const {
    const auto& [picks, options, sampling, field, avoid, askedStart] = task;
    options.validate();
    sampling.validate();
    const std::shared_ptr<const ValidatedField> validated =
        fieldCache_.find(surface(), *extended(), valuesOn(surface(), field), options.fieldCost);
    const LocatedPicks located = locatePicks(surface(), tree(), picks, options.closed);
    const std::vector<int> repeated = located.repeated();
    std::optional<Obstacles> obstacles;
    if (!avoid.empty()) {
        requireExactAvoidance(options);
        obstacles.emplace(
            surface(), *extended(), avoid, options.avoidMargin * surface().diagonal()
        );
        refuseAvoidedPicks(surface(), *obstacles, located);
    }
    const std::vector<int> numbers = located.firstPicks();
    const DesignContext context{
        *validated,
        obstacles ? &*obstacles : nullptr,
        repeated.empty() ? askedStart : nullptr,  // which has as many picks as were asked for
        numbers
    };
    std::optional<WorkerThread> side;
    if (areWorthTwoThreads(surface().faces().size())) {
        side.emplace();
    }
    const CurveSolver solver(*this, located.points, options, context, side ? &*side : nullptr);
    Solved solved = solver.solve(progress);
    Stopwatch watch;
    Curve curve = curveOf(surface(), solved, sampling);
    if (!isStrict(surface(), curve.polyline)) {
        solved = solver.solveTightly(progress);
        curve = curveOf(surface(), solved, sampling);
        curve.report.usable = curve.report.usable && isStrict(surface(), curve.polyline);
    }
    const CurveProblem& problem = solved.problem;
    curve.report.allowedDistance = problem.distanceTolerance / problem.averageEdgeLength;
    curve.report.meanEdgeLength = surface().averageEdgeLength();
    curve.report.diagonal = surface().diagonal();
    if (obstacles) {
        requireClear(surface(), curve.polyline, *obstacles);
        curve.report.clearance = clearanceOf(curve.polyline, surface(), avoid);
    }
    if (obstacles || !field.empty() || problem.shell != nullptr) {
        reportDetour(*this, numbers, curve);
    }
    if (!repeated.empty()) {
        giveRepeatedPicks(located, curve);
        curve.report.repeatedPicks = repeated;
    }
    curve.report.seconds.polyline = watch.lap();
    bspline_curve::report(progress, 1.0, "done");
    return curve;
}

}  // namespace bspline_curve
