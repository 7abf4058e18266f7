// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/surface_curves.h"

#include "bspline_curve/error.h"
#include "bspline_curve/progress.h"
#include "bspline_curve/spline.h"
#include "design/curve_sections.h"
#include "design/curve_solver.h"
#include "design/detours.h"
#include "design/fitted_curve.h"
#include "design/near_curve.h"
#include "design/pick_tangents.h"
#include "design/solved_curve.h"
#include "solver/obstacles.h"
#include "surface/field_on_surface.h"
#include "surface/picks.h"
#include "surface/strict_line.h"
#include "surface/surface_point.h"
#include "text/error_messages.h"
#include "utility/index_sets.h"
#include "utility/stopwatch.h"
#include "utility/worker_task.h"
#include "utility/worker_thread.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <numeric>
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

/// Of the progress, for a curve near the picks, before one through them.
constexpr double kNearPicksShare = 0.6;

void requireOneForEach(std::size_t count, const CurveTask& task, const char* what) {
    if (count != 0 && count != task.picks.size()) {
        throw InputError(
            InputErrorCode::BadOption,
            "there are " + std::to_string(count) + " pick " + what + " for " +
                describeCount(task.picks.size(), "pick", "picks") + ": give one for each"
        );
    }
}

void requireAmount(double amount, std::size_t pick, const char* what) {
    if (!(amount >= 0.0) || !std::isfinite(amount)) {
        throw InputError(
            InputErrorCode::BadOption,
            std::string("the ") + what + " of " + describePicks({static_cast<std::int64_t>(pick)}) +
                " must be finite and not negative"
        );
    }
}

/// Of each point, in the user's unit: the least tolerance and the largest weight of its picks.
std::vector<PickLeeway> leewaysOf(
    const Surface& surface, const CurveTask& task, const LocatedPicks& located
) {
    requireOneForEach(task.pickTolerances.size(), task, "tolerances");
    requireOneForEach(task.pickWeights.size(), task, "weights");
    constexpr double kNoBound = std::numeric_limits<double>::infinity();
    const double perLength = 1.0 / (surface.diagonal() * surface.diagonal());
    std::vector<PickLeeway> leeways(located.points.size(), {kNoBound, 0.0});
    for (std::size_t i = 0; i < located.pointOf.size(); ++i) {
        const MeshLength& length =
            task.pickTolerances.empty() ? task.options.pickTolerance : task.pickTolerances[i];
        const double weight = task.pickWeights.empty() ? 0.0 : task.pickWeights[i];
        requireAmount(length.value, i, "tolerance");
        requireAmount(weight, i, "weight");
        PickLeeway& leeway = leeways[located.pointOf[i]];
        leeway.weight = std::max(leeway.weight, weight * perLength);
        if (weight == 0.0) {
            leeway.bound = std::min(leeway.bound, length.in(surface.averageEdgeLength()));
        }
    }
    return leeways;
}

/// Points at which corners are, ascending.
std::vector<int> cornersOf(const CurveTask& task, const LocatedPicks& located) {
    const auto count = static_cast<int>(task.picks.size());
    std::vector<int> corners;
    for (const int pick : task.corners) {
        if (pick < 0 || pick >= count) {
            throw InputError(
                InputErrorCode::BadOption,
                describePicks({pick}) + " is to be a corner, but there are " +
                    describeCount(task.picks.size(), "pick", "picks"),
                {pick}
            );
        }
        corners.push_back(located.pointOf[pick]);
    }
    sortUnique(corners);
    return corners;
}

/// Whether the curve need not pass all of them.
bool isAnyApart(std::span<const PickLeeway> leeways) {
    return std::ranges::any_of(leeways, [](const PickLeeway& l) { return l.bound > 0.0; });
}

/// What is asked of the points of a curve.
struct PointDemands {
    bool isNear = false;                     ///< to some of them
    std::vector<PickLeeway> leeways;         ///< of each, in the user's unit
    std::vector<std::vector<int>> sections;  ///< see pointsOfSections()
    std::vector<PickTangent> tangents;       ///< see tangentsOf()
};

PointDemands demandsOf(
    const PreparedSurface& prepared, const CurveTask& task, const LocatedPicks& located
) {
    PointDemands demands;
    demands.leeways = leewaysOf(prepared.surface(), task, located);
    demands.isNear = isAnyApart(demands.leeways);
    const std::vector<int> corners = cornersOf(task, located);
    demands.sections =
        pointsOfSections(static_cast<int>(located.points.size()), corners, task.options.closed);
    demands.tangents =
        tangentsOf(*prepared.extended(), located, task.tangents, corners, task.options);
    for (std::size_t i = 0; i < demands.tangents.size(); ++i) {
        if (!demands.tangents[i].isAny()) {
            demands.leeways[i] = {};
        }
    }
    return demands;
}

/// Through the picks.
NearCurve drawThrough(const LocatedTask& task, const Progress& progress) {
    const Surface& surface = task.prepared.surface();
    const CurveSolver solver = task.solver();
    NearCurve drawn{{}, solver.solve(progress)};
    Stopwatch watch;
    auto& [curve, solved] = drawn;
    curve = curveOf(surface, solved, task.sampling);
    if (!isStrict(surface, curve.polyline)) {
        solved = solver.solveTightly(progress);
        curve = curveOf(surface, solved, task.sampling);
        curve.report.usable = curve.report.usable && isStrict(surface, curve.polyline);
    }
    curve.report.seconds.polyline = watch.lap();
    return drawn;
}

/// As near to the picks as the leeways say, user's unit; where there is no such curve, through
/// them.
Curve drawSmooth(
    const LocatedTask& task, std::span<const PickLeeway> leeways, const Progress& progress
) {
    std::optional<NearCurve> drawn;
    if (isAnyApart(leeways)) {
        drawn = drawNear(task, leeways, partOf(progress, 0.0, kNearPicksShare));
        if (!drawn || !isStrict(task.prepared.surface(), drawn->curve.polyline)) {
            drawn = drawThrough(task, partOf(progress, kNearPicksShare, 1.0));
        }
    } else {
        drawn = drawThrough(task, progress);
    }
    const CurveProblem& problem = drawn->solved.problem;
    drawn->curve.report.allowedDistance = problem.distanceTolerance / problem.averageEdgeLength;
    return std::move(drawn->curve);
}

template <class Value>
std::vector<Value> chosenOf(std::span<const Value> values, std::span<const int> indices) {
    std::vector<Value> chosen;
    for (const int i : indices) {
        chosen.push_back(values[i]);
    }
    return chosen;
}

/// Section by section, each as an open curve.
Curve drawSections(const LocatedTask& task, const PointDemands& demands, const Progress& progress) {
    const std::vector<std::vector<int>>& pointsOfEach = demands.sections;
    SolverOptions options = task.options;
    options.closed = false;
    const Curve* const start = task.context.start;
    const std::vector<Curve> starts =
        start != nullptr ? sectionsOfCurve(*start, pointsOfEach) : std::vector<Curve>();
    std::vector<DrawnSection> sections;
    for (std::size_t s = 0; s < pointsOfEach.size(); ++s) {
        const std::vector<int>& points = pointsOfEach[s];
        const auto picks = chosenOf(std::span(task.picks), points);
        const std::vector<int> numbers = chosenOf(task.context.pickNumbers, points);
        std::vector<PickLeeway> reaches = chosenOf(std::span(demands.leeways), points);
        // Both sections of a corner end there.
        const bool isFirst = !task.options.closed && s == 0;
        const bool isLast = !task.options.closed && s + 1 == pointsOfEach.size();
        reaches.front() = isFirst ? reaches.front() : PickLeeway();
        reaches.back() = isLast ? reaches.back() : PickLeeway();
        DesignContext context = task.context;
        context.start = starts.empty() ? nullptr : &starts[s];
        context.pickNumbers = numbers;
        const std::vector<Vec3> tangents = tangentsOfPiece(demands.tangents, points, false);
        context.tangents = tangents;
        const LocatedTask section{task.prepared, picks, options, task.sampling, context, task.side};
        sections.push_back(
            {points, drawSmooth(section, reaches, stepOf(progress, s, pointsOfEach.size()))}
        );
    }
    return joinedCurve(sections, task.options.closed);
}

void reportNearPicks(const Surface& surface, const LocatedPicks& located, Curve& curve) {
    for (const int point : located.pointOf) {
        curve.nearPicks.push_back(located.points[point]);
        curve.nearPickPositions.push_back(surface.position(located.points[point]));
    }
    curve.report.pickDistances = distancesTo(curve.polyline, curve.nearPickPositions);
}

/// What the curve avoids, and no pick is on.
void placeObstacles(
    const PreparedSurface& prepared,
    const CurveTask& task,
    const LocatedPicks& located,
    std::optional<Obstacles>& obstacles
) {
    requireExactAvoidance(task.options);
    const Surface& surface = prepared.surface();
    const double margin = task.options.avoidMargin * surface.diagonal();
    obstacles.emplace(surface, *prepared.extended(), task.avoid, margin);
    refuseAvoidedPicks(surface, *obstacles, located);
}

}  // namespace

Curve SurfaceCurves::design(const CurveTask& task, const Progress& progress) const {
    const SolverOptions& options = task.options;
    const SamplingOptions& sampling = task.sampling;
    const Region& avoid = task.avoid;
    options.validate();
    sampling.validate();
    const std::shared_ptr<const ValidatedField> validated = fieldCache_.find(
        surface(), *extended(), valuesOn(surface(), task.field), options.fieldCost
    );
    const LocatedPicks located =
        locatePicks(surface(), tree(), task.picks, options.closed, options.pickDistance);
    const std::vector<int> repeated = located.repeated();
    std::optional<Obstacles> obstacles;
    if (!avoid.empty()) {
        placeObstacles(*this, task, located, obstacles);
    }
    const PointDemands demands = demandsOf(*this, task, located);
    const std::vector<int> numbers = located.firstPicks();
    std::vector<int> points(located.points.size());
    std::iota(points.begin(), points.end(), 0);
    const std::vector<Vec3> tangents = tangentsOfPiece(demands.tangents, points, options.closed);
    const DesignContext context{
        .field = *validated,
        .obstacles = obstacles ? &*obstacles : nullptr,
        // With as many picks as were asked for.
        .start = repeated.empty() && !demands.isNear ? task.start : nullptr,
        .keepsKnots = task.isPreview,
        .pickNumbers = numbers,
        .tangents = tangents
    };
    std::optional<WorkerThread> side;
    if (areWorthTwoThreads(surface().faces().size())) {
        side.emplace();
    }
    const LocatedTask here{
        *this, located.points, options, sampling, context, side ? &*side : nullptr
    };
    Curve curve = demands.sections.empty() ? drawSmooth(here, demands.leeways, progress)
                                           : drawSections(here, demands, progress);
    Stopwatch watch;
    if (demands.isNear) {
        reportNearPicks(surface(), located, curve);
    }
    curve.report.meanEdgeLength = surface().averageEdgeLength();
    curve.report.diagonal = surface().diagonal();
    if (obstacles) {
        requireClear(surface(), curve.polyline, *obstacles);
        curve.report.clearance = clearanceOf(curve.polyline, surface(), avoid);
    }
    if (obstacles || !task.field.empty() || curve.shell) {
        reportDetour(*this, numbers, curve);
    }
    if (!repeated.empty()) {
        giveRepeatedPicks(located, curve);
        curve.report.repeatedPicks = repeated;
    }
    curve.report.tangents = metTangents(*extended(), located, demands.tangents, curve);
    curve.report.seconds.polyline += watch.lap();
    bspline_curve::report(progress, 1.0, "done");
    return curve;
}

Curve SurfaceCurves::fit(const LineTask& task, const Progress& progress) const {
    const auto& [line, fit, options, sampling] = task;
    options.validate();
    sampling.validate();
    fit.validate();
    const LocatedPicks located =
        locatePicks(surface(), tree(), line, options.closed, options.pickDistance, kVertexWords);
    const std::shared_ptr<const ValidatedField> none =
        fieldCache_.find(surface(), *extended(), {}, options.fieldCost);
    const DesignContext context{.field = *none};
    std::optional<WorkerThread> side;
    if (areWorthTwoThreads(surface().faces().size())) {
        side.emplace();
    }
    const LocatedTask here{
        *this, located.points, options, sampling, context, side ? &*side : nullptr
    };
    Curve curve = fitLine(here, fit, progress);
    curve.report.meanEdgeLength = surface().averageEdgeLength();
    curve.report.diagonal = surface().diagonal();
    bspline_curve::report(progress, 1.0, "done");
    return curve;
}

}  // namespace bspline_curve
