// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/designer.h"
#include "bspline_curve/error.h"
#include "design/curve_solver.h"
#include "design/detours.h"
#include "design/field_cache.h"
#include "design/prepared_surface.h"
#include "design/rejoined_designers.h"
#include "design/spline_data.h"
#include "design/strict_polyline.h"
#include "projection/fibre_tracer.h"
#include "projection/projected_curve.h"
#include "shell/shell_layers.h"
#include "shell/shell_store.h"
#include "solver/obstacles.h"
#include "solver/problem_traces.h"
#include "surface/error_messages.h"
#include "surface/field_on_surface.h"
#include "surface/picks.h"
#include "surface/region.h"
#include "surface/strict_line.h"
#include "surface/surface_point.h"
#include "surface/weld_remedy.h"
#include "utility/index_sets.h"
#include "utility/report_progress.h"
#include "utility/sparse_map.h"
#include "utility/stopwatch.h"
#include "utility/worker_task.h"
#include "utility/worker_thread.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
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

// Shares of the progress for the surface, and for what comes before the shell.
constexpr double kValidShare = 0.02;
constexpr double kPreparedShare = 0.1;

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
    return makeStrictPolyline(surface, problem, shadow, sampling);
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

/// `asked`: faces of the surface's input, `avoided`: those of the surface.
void reportAvoided(
    const Surface& surface, std::span<const int> asked, const Region& avoided, Curve& curve
) {
    std::vector<int> faces(asked.begin(), asked.end());
    sortUnique(faces);
    curve.report.avoidedFaces = static_cast<int>(faces.size());
    curve.report.clearance = clearanceOf(curve.polyline, surface, avoided);
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

namespace {

/// The legs of a curve that is still to be drawn.
std::vector<CurveLeg> legsBetween(
    const TriangleTree& tree, const std::vector<Vec3>& picks, bool closed
) {
    std::vector<SurfacePoint> points;
    for (const Vec3& pick : picks) {
        points.push_back(tree.closestPoint(pick).point);
    }
    if (closed) {
        points.push_back(points.front());
    }
    std::vector<CurveLeg> legs;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        legs.push_back({points[i], points[i + 1], std::numeric_limits<double>::infinity()});
    }
    return legs;
}

/// The legs that go farther than they need. `isRejoined`: on the mesh that was joined for the ways.
std::vector<Detour> detoursOf(
    const SurfacePolyline& line, const RejoinedDesigners::Ways& ways, bool isRejoined
) {
    constexpr double kLongest = 1.5;  // a curve bends less than the shortest way, and goes farther
    const std::vector<CurveLeg> legs = curveLegsOf(line);
    std::vector<Detour> detours;
    const auto count = static_cast<int>(line.picks.size());
    const auto detourOf = [&](int leg, double ratio, Detour::Round round) {
        return Detour{.from = leg, .to = (leg + 1) % count, .ratio = ratio, .round = round};
    };
    for (const auto& [leg, before, shortest, isOverSlit] : ways.shorter) {
        if (isOverSlit || !isRejoined) {
            detours.push_back(detourOf(
                leg,
                legs[leg].length / shortest,
                isOverSlit ? Detour::Round::Slit : Detour::Round::Cut
            ));
        }
    }
    for (std::size_t i = 0; isRejoined && i < legs.size(); ++i) {
        const double ratio = legs[i].length / ways.lengths[i];
        if (ratio > kLongest &&
            std::ranges::find(detours, static_cast<int>(i), &Detour::from) == detours.end()) {
            detours.push_back(detourOf(static_cast<int>(i), ratio, Detour::Round::Cut));
        }
    }
    std::ranges::sort(detours, {}, &Detour::from);
    return detours;
}

}  // namespace

struct CurveDesigner::State : PreparedSurface {
    using PreparedSurface::PreparedSurface;

    /// As CurveDesigner::design(), on the components that there are; the curve has the surface's
    /// own ids. `avoid`: likewise.
    [[nodiscard]] Curve design(
        const std::vector<Vec3>& picks,
        const SolverOptions& options,
        const SamplingOptions& sampling,
        const CurveInputs& inputs,
        const Region& avoid,
        const Progress& progress
    ) const;

    /// The faces to avoid. Throws InputError.
    [[nodiscard]] Region regionOf(const CurveInputs& inputs) const {
        return surface().provenance().facesFromInput(makeRegion(
            surface().input(), std::vector<std::int64_t>(inputs.avoid.begin(), inputs.avoid.end())
        ));
    }

    /// The same where mending has parted faces or left slits: over the former where that is
    /// shorter. The curve has the ids of the surface's input.
    [[nodiscard]] Curve designOverParted(
        const std::vector<Vec3>& picks,
        const SolverOptions& options,
        const SamplingOptions& sampling,
        const CurveInputs& inputs,
        const Region& avoid,
        const Progress& progress
    ) const;

    /// On a surface joined anew for some ways; nothing where that does not help. Starts from no
    /// other curve; ids are the input's.
    [[nodiscard]] std::optional<Curve> designRejoined(
        const std::vector<Step>& steps,
        const std::vector<Vec3>& picks,
        const SolverOptions& options,
        const SamplingOptions& sampling,
        const CurveInputs& inputs,
        const Progress& progress
    ) const;

    mutable FieldCache fieldCache;
    std::unique_ptr<RejoinedDesigners> rejoinedDesigners{};  ///< null: nothing is to be joined
};

namespace {

/// The curve from which one may start, with the surface's own ids; none where it does not lie on
/// it.
std::optional<Curve> startOn(const Surface& surface, const Curve* start) {
    if (start == nullptr) {
        return std::nullopt;
    }
    std::optional<Curve> own(*start);
    if (!surface.provenance().isIdentity()) {
        try {
            own->polyline = strictLine(surface, std::move(own->polyline), "the start");
        } catch (const InputError&) {
            return std::nullopt;  // it passes from sheet to sheet: the curve starts from scratch
        }
    }
    return own;
}

}  // namespace

CurveDesigner::CurveDesigner(
    TriangleMesh mesh,
    const ShellOptions& options,
    const MendingOptions& mending,
    const Progress& progress,
    const ShellStore* store
) {
    options.validate();
    Stopwatch watch;
    auto surface = std::make_shared<const Surface>(
        std::move(mesh), mending, partOf(progress, 0.0, kValidShare)
    );
    *this = CurveDesigner(
        std::move(surface), options, partOf(progress, kValidShare, 1.0), store, watch.lap()
    );
}

CurveDesigner::CurveDesigner(
    std::shared_ptr<const Surface> surface,
    const ShellOptions& options,
    const Progress& progress,
    const ShellStore* store,
    double seconds
) {
    state_ = std::make_unique<State>(
        std::move(surface), options, partOf(progress, 0.0, kPreparedShare), seconds
    );
    const RepairReport* const repair = state_->surface().provenance().report();
    // One that was joined anew has no report.
    if (state_->surface().leavesSlits() || (repair != nullptr && !repair->isEmpty())) {
        auto designers = std::make_unique<RejoinedDesigners>(state_->surface());
        if (!designers->empty()) {
            state_->rejoinedDesigners = std::move(designers);
        }
    }
    bspline_curve::report(progress, kPreparedShare, "building the shell");
    if (options.kind != ShellKind::Local) {
        static_cast<void>(state_->wholeShell(partOf(progress, kPreparedShare, 1.0), store));
    }
}

CurveDesigner::~CurveDesigner() = default;
CurveDesigner::CurveDesigner(CurveDesigner&&) noexcept = default;
CurveDesigner& CurveDesigner::operator=(CurveDesigner&&) noexcept = default;

const TriangleMesh& CurveDesigner::mesh() const {
    return state_->surface().input();
}

const Surface& CurveDesigner::surface() const {
    return state_->surface();
}

const TriangleTree& CurveDesigner::tree() const {
    return state_->tree();
}

StageSeconds CurveDesigner::seconds() const {
    const PreparedSurface::Seconds all = state_->seconds();
    return {all.validate, all.tree, all.extended + all.wholeShell};
}

ShellSummary CurveDesigner::shell() const {
    const ObtainedShell* const whole = state_->wholeShellIfBuilt();
    return whole == nullptr
               ? ShellSummary{state_->options().kind, false, {}}
               : ShellSummary{state_->options().kind, whole->isFromStore, whole->notes};
}

ShellLayers CurveDesigner::shellLayers() const {
    return makeShellLayers(state_->wholeShell().build.shell, state_->extended()->frame);
}

Curve CurveDesigner::design(
    const std::vector<Vec3>& picks,
    const SolverOptions& options,
    const SamplingOptions& sampling,
    const CurveInputs& inputs,
    const Progress& progress
) const {
    const Region avoid = state_->regionOf(inputs);
    try {
        if (state_->rejoinedDesigners != nullptr) {
            return state_->designOverParted(picks, options, sampling, inputs, avoid, progress);
        }
        Curve curve = state_->design(picks, options, sampling, inputs, avoid, progress);
        surface().provenance().bringToInput(curve);
        return curve;
    } catch (const InputError& error) {
        if (error.code() != InputErrorCode::PicksOnDifferentComponents) {
            throw;
        }
        const Remedy remedy = weldFor(surface(), tree(), picks, options.closed, progress);
        throw InputError(error.code(), error.what(), error.elements(), remedy);
    }
}

Curve CurveDesigner::State::designOverParted(
    const std::vector<Vec3>& picks,
    const SolverOptions& options,
    const SamplingOptions& sampling,
    const CurveInputs& inputs,
    const Region& avoid,
    const Progress& progress
) const {
    std::optional<Curve> curve;
    std::optional<InputError> refusal;
    try {
        curve = design(picks, options, sampling, inputs, avoid, progress);
    } catch (const InputError& error) {
        if (error.code() != InputErrorCode::PicksOnDifferentComponents &&
            error.code() != InputErrorCode::NoPath) {
            throw;
        }
        refusal = error;
    }
    const std::vector<CurveLeg> legs =
        curve ? curveLegsOf(curve->polyline) : legsBetween(tree(), picks, options.closed);
    if (curve) {
        surface().provenance().bringToInput(*curve);
    }
    const Progress rest = partOf(progress, curve ? 1.0 : 0.0, 1.0);
    const RejoinedDesigners::Ways ways = rejoinedDesigners->waysFor(legs, avoid, rest);
    bool isRejoined = false;
    if (!ways.steps.empty()) {
        std::optional<Curve> other =
            designRejoined(ways.steps, picks, options, sampling, inputs, rest);
        // With a field it is the field's matter how long a curve is.
        if (other && (!curve || (other->report.usable &&
                                 (!inputs.field.empty() || !curve->report.usable ||
                                  lengthOf(other->polyline) < lengthOf(curve->polyline))))) {
            curve = std::move(other);
            isRejoined = true;
        }
    }
    if (!curve) {
        const bool isSlit =
            std::ranges::any_of(ways.shorter, [](const auto& leg) { return leg.isOverSlit; });
        const std::string slits =
            isSlit ? "; slits part them, which are joined without the options strict and slits"
                   : "";
        throw InputError(refusal->code(), refusal->what() + slits, refusal->elements());
    }
    for (const Detour& detour : detoursOf(curve->polyline, ways, isRejoined)) {
        std::erase_if(curve->report.detours, [&](const Detour& d) {
            return d.from == detour.from;
        });
        curve->report.detours.push_back(detour);
    }
    std::ranges::sort(curve->report.detours, {}, &Detour::from);
    return *std::move(curve);
}

std::optional<Curve> CurveDesigner::State::designRejoined(
    const std::vector<Step>& steps,
    const std::vector<Vec3>& picks,
    const SolverOptions& options,
    const SamplingOptions& sampling,
    const CurveInputs& inputs,
    const Progress& progress
) const {
    const auto there = rejoinedDesigners->designerFor(
        steps, this->options(), partOf(progress, 0.0, kPreparedShare)
    );
    if (there == nullptr) {
        return std::nullopt;
    }
    const ScalarField field = rejoinedField(surface(), inputs.field, there->surface());
    try {
        return there->design(
            picks,
            options,
            sampling,
            {.field = field, .avoid = inputs.avoid},
            partOf(progress, kPreparedShare, 1.0)
        );
    } catch (const InputError&) {
        return std::nullopt;  // what is wrong without the ways says more
    }
}

Curve CurveDesigner::State::design(
    const std::vector<Vec3>& picks,
    const SolverOptions& options,
    const SamplingOptions& sampling,
    const CurveInputs& inputs,
    const Region& avoid,
    const Progress& progress
) const {
    options.validate();
    sampling.validate();
    const std::shared_ptr<const ValidatedField> field = fieldCache.find(
        surface(), *extended(), valuesOn(surface(), inputs.field), options.fieldCost
    );
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
    const std::vector<int> numbers = located.given();
    const std::optional<Curve> start =
        startOn(surface(), repeated.empty() ? inputs.start : nullptr);  // it has as many picks
    const DesignContext context{
        *field, obstacles ? &*obstacles : nullptr, start ? &*start : nullptr, numbers
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
        reportAvoided(surface(), inputs.avoid, avoid, curve);
    }
    if (obstacles || !inputs.field.empty() || problem.shell != nullptr) {
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
