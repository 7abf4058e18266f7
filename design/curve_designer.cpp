// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/designer.h"
#include "bspline_curve/error.h"
#include "design/curve_solver.h"
#include "design/designer_surface.h"
#include "design/field_cache.h"
#include "design/prepared_surface.h"
#include "design/strict_polyline.h"
#include "projection/fibre_tracer.h"
#include "projection/projected_curve.h"
#include "shell/shell_layers.h"
#include "shell/shell_store.h"
#include "solver/obstacles.h"
#include "surface/picks.h"
#include "surface/region.h"
#include "surface/surface_point.h"
#include "utility/report_progress.h"
#include "utility/sparse_map.h"
#include "utility/stopwatch.h"
#include "utility/worker_task.h"
#include "utility/worker_thread.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace bspline_curve {
namespace {

// What the curve avoids is certain only where every iterate is checked as a whole.
void requireExactAvoidance(const SolverOptions& options) {
    const auto refuse = [](const std::string& option, const std::string& needed) {
        throw InputError(
            InputErrorCode::BadOption,
            option + " cannot keep a curve out of the faces to avoid: use " + needed
        );
    };
    if (options.quadrature == Quadrature::Samples) {
        refuse("quadrature = samples", "cells");
    }
    if (options.initialCurve != InitialCurve::GeodesicFit) {
        refuse("initial_curve = control-polygon", "geodesic-fit");
    }
    if (options.interpolation != Interpolation::Constraint) {
        refuse("interpolation = penalty", "constraint");
    }
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
    const Surface& surface, const Obstacles& obstacles, const std::vector<SurfacePoint>& picks
) {
    const auto refuse = [](std::size_t pick, int face, const std::string& what) {
        throw InputError(
            InputErrorCode::PickAvoided,
            "pick " + std::to_string(pick) + " lies in face " + std::to_string(face) + what +
                ": move the pick, or avoid fewer faces",
            {static_cast<std::int64_t>(pick)}
        );
    };
    for (std::size_t i = 0; i < picks.size(); ++i) {
        for (const int f : facesHolding(surface, picks[i])) {
            if (obstacles.isAvoided(f)) {
                refuse(i, f, ", which the curve is to avoid");
            }
        }
        if (obstacles.closeness(picks[i]) >= 1.0) {
            refuse(i, picks[i].face, ", all of whose neighbours the curve is to avoid");
        }
    }
}

[[noreturn]] void refuseLostCurve(SolveStatus status) {
    throw InputError(
        InputErrorCode::NoShell,
        std::string("the curve left the shell and did not find back (") + name(status) +
            "): use the default preset, or add picks"
    );
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

// Share of the progress for what comes before the shell.
constexpr double kPreparedShare = 0.1;

// In the shell's frame.
SplineCurve splineOf(const SplineData& data, const ShellFrame& frame) {
    const auto degree = static_cast<std::ptrdiff_t>(data.degree);
    SplineSpace space(
        data.degree,
        data.closed,
        std::vector<double>(data.knots.begin() + degree, data.knots.end() - degree)
    );
    ControlPoints controls(space.controlCount(), 3);
    for (int c = 0; c < space.controlCount(); ++c) {
        controls.row(c) = frame.toUnit(data.controlPoints[c]).transpose();
    }
    return {std::move(space), std::move(controls)};
}

}  // namespace

struct CurveDesigner::State : PreparedSurface {
    using PreparedSurface::PreparedSurface;

    mutable FieldCache fieldCache;

    [[nodiscard]] StageSeconds stageSeconds() const;
    [[nodiscard]] ShellSummary summary() const;

    [[nodiscard]] Region regionOf(std::span<const int> faces) const;
    [[nodiscard]] std::optional<Obstacles> obstaclesOf(
        const Region& region, const SolverOptions& options
    ) const;
    void measureClearance(const Region& region, Curve& curve) const;
    [[nodiscard]] SurfacePolyline polylineOf(
        const CurveProblem& problem,
        const SplineCurve& spline,
        std::optional<CurveTrace> trace,
        const SamplingOptions& sampling
    ) const;
    [[nodiscard]] SplineData exportSpline(
        const SplineCurve& curve, const CurveProblem& problem
    ) const;
};

StageSeconds CurveDesigner::State::stageSeconds() const {
    const Seconds all = seconds();
    return {all.validate, all.tree, all.extended + all.wholeShell};
}

ShellSummary CurveDesigner::State::summary() const {
    ShellSummary summary;
    summary.kind = options().kind;
    if (const ObtainedShell* const whole = wholeShellIfBuilt()) {
        summary.isFromStore = whole->isFromStore;
        summary.notes = whole->notes;
    }
    return summary;
}

Region CurveDesigner::State::regionOf(std::span<const int> faces) const {
    return makeRegion(surface(), std::vector<std::int64_t>(faces.begin(), faces.end()));
}

std::optional<Obstacles> CurveDesigner::State::obstaclesOf(
    const Region& region, const SolverOptions& options
) const {
    if (region.empty()) {
        return std::nullopt;
    }
    requireExactAvoidance(options);
    return std::optional<Obstacles>(
        std::in_place, surface(), *extended(), region, options.avoidMargin * surface().diagonal()
    );
}

// `trace`: of this spline, in the problem's shell or along the fibres.
SurfacePolyline CurveDesigner::State::polylineOf(
    const CurveProblem& problem,
    const SplineCurve& spline,
    std::optional<CurveTrace> trace,
    const SamplingOptions& sampling
) const {
    const auto& [space, controls] = spline;
    if (problem.shell != nullptr && !problem.shell->isFullResolution()) {
        // The fibres of a simplified shell are oblique to the surface, so a spline that is smooth
        // and within its tolerance has a shadow along them that is less smooth.
        CurveDistance fine = measureAlongFibres(problem, space, controls);
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
    const ProjectedCurve shadow(problem, space, controls, std::move(*trace));
    return makeStrictPolyline(surface(), problem, shadow, sampling);
}

void CurveDesigner::State::measureClearance(const Region& region, Curve& curve) const {
    std::vector<Triangle> avoided;
    for (const int f : region) {
        avoided.push_back(surface().faces()[f]);
    }
    const TriangleTree avoidedTree(surface().vertices(), avoided);
    curve.report.avoidedFaces = static_cast<int>(region.size());
    for (const Vec3& point : curve.polyline.points) {
        curve.report.clearance = std::min(
            curve.report.clearance, std::sqrt(avoidedTree.closestPoint(point).squaredDistance)
        );
    }
}

SplineData CurveDesigner::State::exportSpline(
    const SplineCurve& curve, const CurveProblem& problem
) const {
    SplineData data;
    data.degree = curve.space.degree();
    data.closed = curve.space.closed();
    data.knots = curve.space.knotVector();
    const int repeated = data.closed ? data.degree : 0;
    for (int i = 0; i < curve.space.controlCount() + repeated; ++i) {
        const int c = i % curve.space.controlCount();
        data.controlPoints.push_back(extended()->frame.toUser(curve.controls.row(c).transpose()));
    }
    for (const PickConstraint& pick : problem.picks) {
        data.pickParameters.push_back(pick.parameter);
    }
    return data;
}

CurveDesigner::CurveDesigner(
    TriangleMesh mesh,
    const ShellOptions& options,
    const Progress& progress,
    const ShellStore* store
) {
    bspline_curve::report(progress, 0.0, "preparing the surface");
    state_ = std::make_unique<State>(std::move(mesh), options);
    bspline_curve::report(progress, kPreparedShare, "building the shell");
    if (options.kind != ShellKind::Local) {
        static_cast<void>(state_->wholeShell(partOf(progress, kPreparedShare, 1.0), store));
    }
}

CurveDesigner::~CurveDesigner() = default;
CurveDesigner::CurveDesigner(CurveDesigner&&) noexcept = default;
CurveDesigner& CurveDesigner::operator=(CurveDesigner&&) noexcept = default;

const TriangleMesh& CurveDesigner::mesh() const {
    return state_->surface().mesh();
}

const Surface& surfaceOf(const CurveDesigner& designer) {
    return designer.state_->surface();
}

StageSeconds CurveDesigner::seconds() const {
    return state_->stageSeconds();
}

ShellSummary CurveDesigner::shell() const {
    return state_->summary();
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
    options.validate();
    sampling.validate();
    const State& state = *state_;
    const std::shared_ptr<const ValidatedField> field =
        state.fieldCache.find(state.surface(), *state.extended(), inputs.field, options.fieldCost);
    const std::vector<SurfacePoint> located =
        locatePicks(state.surface(), state.tree(), picks, options.closed);
    const Region region = state.regionOf(inputs.avoid);
    const std::optional<Obstacles> obstacles = state.obstaclesOf(region, options);
    if (obstacles) {
        refuseAvoidedPicks(state.surface(), *obstacles, located);
    }
    const DesignContext context{*field, obstacles ? &*obstacles : nullptr, inputs.start};
    std::optional<WorkerThread> side;
    if (areWorthTwoThreads(state.surface().faces().size())) {
        side.emplace();
    }
    auto [problem, solution] =
        CurveSolver(state, located, options, context, side ? &*side : nullptr).solve(progress);
    if (!std::isfinite(solution.report.maxDistance)) {
        refuseLostCurve(solution.report.status);
    }

    Stopwatch watch;
    Curve curve;
    describeShell(problem, solution, curve);
    curve.polyline = state.polylineOf(problem, solution.curve, std::move(solution.trace), sampling);
    curve.spline = state.exportSpline(solution.curve, problem);
    curve.report = solution.report;
    curve.report.allowedDistance = problem.distanceTolerance / problem.averageEdgeLength;
    if (obstacles) {
        requireClear(state.surface(), curve.polyline, *obstacles);
        state.measureClearance(region, curve);
    }
    curve.report.seconds.polyline = watch.lap();
    report(progress, 1.0, "done");
    return curve;
}

SurfacePolyline CurveDesigner::resample(
    const Curve& curve, const SamplingOptions& sampling, std::span<const int> avoid
) const {
    sampling.validate();
    const State& state = *state_;
    const SplineData& data = curve.spline;
    const SplineCurve spline = splineOf(data, state.extended()->frame);
    std::vector<PickConstraint> picks;
    for (std::size_t i = 0; i < data.pickParameters.size(); ++i) {
        const SurfacePoint& point = curve.polyline.surfacePoints[curve.polyline.picks[i]];
        picks.push_back({point, state.extended()->position(point), data.pickParameters[i]});
    }
    SolverOptions options;
    options.degree = data.degree;
    options.closed = data.closed;
    CurveProblem problem = makeProblem(state, options, std::move(picks));
    const std::optional<Obstacles> obstacles = state.obstaclesOf(state.regionOf(avoid), options);
    problem.obstacles = obstacles ? &*obstacles : nullptr;
    std::optional<CurveTrace> trace;
    if (state.options().kind == ShellKind::Local) {
        CurveDistance distance = measureAlongFibres(problem, spline.space, spline.controls);
        if (std::isfinite(distance.largest)) {
            trace = std::move(distance.trace);
        }
    }
    if (!trace) {
        problem.shell = &state.wholeShell().build.shell;
    }
    SurfacePolyline line = state.polylineOf(problem, spline, std::move(trace), sampling);
    if (obstacles) {
        requireClear(state.surface(), line, *obstacles);
    }
    return line;
}

}  // namespace bspline_curve
