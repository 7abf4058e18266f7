// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/curve_designer.h"

#include "design/guide_path.h"
#include "design/near_shell.h"
#include "design/strict_polyline.h"
#include "shell/shell_boundary.h"
#include "shell/shell_store.h"
#include "solver/obstacles.h"
#include "solver/solve.h"
#include "surface/index_sets.h"
#include "surface/input_error.h"
#include "surface/picks.h"
#include "surface/region.h"
#include "surface/stopwatch.h"
#include "surface/surface_point.h"
#include "surface/triangle_tree.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace bspline_curve {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

ShellSummary summaryOf(const ObtainedShell& obtained) {
    const Shell& shell = obtained.build.shell;
    const auto count = std::ranges::count_if(shell.prisms(), [](const Prism& prism) {
        return prism.orientation != 0;
    });
    return {
        .kind = shell.kind(),
        .prisms = static_cast<int>(count),
        .isFromStore = obtained.isFromStore,
        .notes = obtained.notes
    };
}

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

double areaOf(const Surface& surface) {
    double twice = 0.0;
    for (const Triangle& face : surface.faces()) {
        const Vec3& corner = surface.vertices()[at(face[0])];
        const Vec3 u = surface.vertices()[at(face[1])] - corner;
        const Vec3 v = surface.vertices()[at(face[2])] - corner;
        twice += u.cross(v).norm();
    }
    return 0.5 * twice;
}

// Shares of the field by which paths follow it: less where no spline along them stays in the shell.
constexpr std::array<double, 3> kGuideShares = {1.0, 0.25, 0.0};

// What draws a curve somewhere, or keeps it away.
struct Guides {
    std::span<const double> field, vertexCosts;  // and c(I) at each vertex
    const Obstacles* obstacles;
};

// What was solved, and how.
struct Solved {
    CurveProblem problem;
    Solution solution;
};

}  // namespace

struct CurveDesigner::State {
    State(
        TriangleMesh mesh,
        const ShellOptions& options,
        const Progress& progress,
        const ShellStore* store
    )
        : surface(std::move(mesh)),
          validated(watch.lap()),
          tree(surface.vertices(), surface.faces()),
          treeBuilt(watch.lap()),
          base(std::make_shared<const ShellBase>(makeShellBase(surface, options.smoothingPasses))),
          obtained(findOrMakeShell(surface, base, options, store, progress)) {
        seconds = {validated, treeBuilt, watch.lap()};
        keepShell(surface, *base, options, store, obtained);
        summary = summaryOf(obtained);
    }

    Stopwatch watch;
    Surface surface;
    double validated;
    TriangleTree tree;
    PatchLevels patches{surface};
    double finestEdge = kFinestEdge * std::sqrt(areaOf(surface));  ///< shorter ones count as that
    double treeBuilt;
    std::shared_ptr<const ShellBase> base;
    ObtainedShell obtained;
    StageSeconds seconds;
    ShellSummary summary;

    [[nodiscard]] CurveProblem makeProblem(
        const SolverOptions& options,
        std::vector<PickConstraint> picks,
        std::span<const double> field
    ) const;
    [[nodiscard]] std::vector<double> checkedCosts(
        std::span<const double> field, FieldCost cost
    ) const;
    [[nodiscard]] std::vector<double> fieldOnPillars(std::span<const double> field) const;
    void refuseBlockedPicks(const std::vector<SurfacePoint>& picks) const;
    [[nodiscard]] Region regionOf(std::span<const int> faces) const;
    [[nodiscard]] std::optional<Obstacles> obstaclesOf(
        const Region& region, const SolverOptions& options
    ) const;
    [[nodiscard]] Solved solveCurve(
        const std::vector<SurfacePoint>& picks,
        const SolverOptions& options,
        const Guides& guides,
        const Progress& progress
    ) const;
    void measureClearance(const Region& region, Curve& curve) const;
    [[nodiscard]] SurfacePolyline polylineOf(
        const CurveProblem& problem,
        const SplineSpace& space,
        const ControlPoints& controls,
        const SamplingOptions& sampling
    ) const;
    [[nodiscard]] SplineData exportSpline(
        const SplineCurve& curve, const CurveProblem& problem
    ) const;
};

// c(I) at each vertex.
std::vector<double> CurveDesigner::State::checkedCosts(
    std::span<const double> field, FieldCost cost
) const {
    if (field.empty()) {
        return {};
    }
    if (field.size() != surface.vertices().size()) {
        throw InputError(
            InputErrorCode::BadField,
            "the field has " + std::to_string(field.size()) + " values for " +
                std::to_string(surface.vertices().size()) + " vertices: give one value per vertex"
        );
    }
    std::vector<double> costs = vertexCostsOf(field, cost);
    std::vector<std::int64_t> bad;
    for (std::size_t v = 0; v < field.size(); ++v) {
        if (!std::isfinite(field[v]) || !std::isfinite(costs[v])) {
            bad.push_back(static_cast<std::int64_t>(v));
        }
    }
    if (!bad.empty()) {
        throw InputError(
            InputErrorCode::BadField,
            "the field or its cost is not finite at " + std::to_string(bad.size()) + " vertices (" +
                describeElements(bad) + "): give another number there",
            bad
        );
    }
    return costs;
}

std::vector<double> CurveDesigner::State::fieldOnPillars(std::span<const double> field) const {
    if (field.empty()) {
        return {};
    }
    std::vector<double> values(field.begin(), field.end());
    for (const int origin : base->ghostOrigin) {
        values.push_back(field[at(origin)]);
    }
    return values;
}

void CurveDesigner::State::refuseBlockedPicks(const std::vector<SurfacePoint>& picks) const {
    const std::vector<int>& blocked = obtained.build.report.blockedFaces;
    for (std::size_t i = 0; i < picks.size(); ++i) {
        if (std::binary_search(blocked.begin(), blocked.end(), picks[i].face)) {
            throw InputError(
                InputErrorCode::SelfIntersection,
                "pick " + std::to_string(i) + " lies in face " + std::to_string(picks[i].face) +
                    ", where the surface crosses itself or folds onto itself: move the pick, or "
                    "repair the "
                    "mesh there",
                {picks[i].face}
            );
        }
    }
}

Region CurveDesigner::State::regionOf(std::span<const int> faces) const {
    return makeRegion(surface, std::vector<std::int64_t>(faces.begin(), faces.end()));
}

std::optional<Obstacles> CurveDesigner::State::obstaclesOf(
    const Region& region, const SolverOptions& options
) const {
    if (region.empty()) {
        return std::nullopt;
    }
    requireExactAvoidance(options);
    return std::optional<Obstacles>(
        std::in_place, surface, *base, region, options.avoidMargin * surface.diagonal()
    );
}

CurveProblem CurveDesigner::State::makeProblem(
    const SolverOptions& options, std::vector<PickConstraint> picks, std::span<const double> field
) const {
    CurveProblem problem;
    problem.shell = &obtained.build.shell;
    problem.base = base.get();
    problem.picks = std::move(picks);
    problem.field = fieldOnPillars(field);
    problem.options = options;
    problem.averageEdgeLength = surface.averageEdgeLength() / base->frame.scale;
    problem.distanceTolerance = options.distanceTolerance *
                                std::max(surface.averageEdgeLength(), finestEdge) /
                                base->frame.scale;
    for (std::size_t i = 0; i + 1 < problem.picks.size(); ++i) {
        problem.chordLength += (problem.picks[i + 1].position - problem.picks[i].position).norm();
    }
    if (options.closed) {
        problem.chordLength +=
            (problem.picks.front().position - problem.picks.back().position).norm();
    }
    return problem;
}

Solved CurveDesigner::State::solveCurve(
    const std::vector<SurfacePoint>& picks,
    const SolverOptions& options,
    const Guides& guides,
    const Progress& progress
) const {
    std::optional<ShellBoundary> boundary;
    if (options.quadrature == Quadrature::Samples) {
        boundary.emplace(obtained.build.shell);
    }
    Stopwatch lap;
    for (const double share : kGuideShares) {
        const FieldTravel travel = fieldTravelOf(surface, guides.vertexCosts, options, share);
        if (share > 0.0 && travel.empty()) {
            continue;
        }
        PickPath path = makePickPath(
            surface,
            *base,
            picks,
            options.closed,
            {obtained.build.report.blockedFaces, travel, guides.obstacles, &patches}
        );
        CurveProblem problem = makeProblem(options, std::move(path.picks), guides.field);
        problem.fieldCosts = summaryOf(guides.vertexCosts);
        problem.obstacles = guides.obstacles;
        problem.boundary = boundary ? &*boundary : nullptr;
        problem.progress = progress;
        const double pathSeconds = lap.lap();
        if (std::optional<Solution> solution = solve(problem, path.guide)) {
            problem.boundary = nullptr;  // it ends here
            solution->report.seconds.path = pathSeconds;
            return {std::move(problem), std::move(*solution)};
        }
    }
    throw InputError(
        InputErrorCode::NoShell,
        "no spline through the picks stays in the shell: the shell is too thin or interrupted "
        "there; add picks, or check the mesh for faces that cross or fold onto each other"
    );
}

SurfacePolyline CurveDesigner::State::polylineOf(
    const CurveProblem& problem,
    const SplineSpace& space,
    const ControlPoints& controls,
    const SamplingOptions& sampling
) const {
    const ShadowCurve shadow(problem, space, controls);
    if (!shadow.isWhole()) {
        throw std::logic_error("the polyline was asked of a spline that leaves its shell");
    }
    if (problem.shell->isFullResolution()) {
        return makeStrictPolyline(surface, problem, shadow, sampling);
    }
    const double tolerance = problem.distanceTolerance;
    const NearShell near(surface, *base, shadow, tolerance);
    CurveProblem nearProblem = problem;
    nearProblem.shell = &near.shell;
    nearProblem.base = &near.base;
    for (PickConstraint& pick : nearProblem.picks) {
        pick.point.face = near.indexOf(pick.point.face);
    }
    const ShadowCurve fine(nearProblem, space, controls, &near.faces);
    // Other fibres may lead into what the curve avoids.
    const auto isAvoided = [&](int f) { return problem.obstacles->isAvoided(near.faces[at(f)]); };
    const bool isUsable = fine.isWhole() && (problem.obstacles == nullptr ||
                                             std::ranges::none_of(fine.faces(), isAvoided));
    return makeStrictPolyline(surface, problem, isUsable ? fine : shadow, sampling);
}

void CurveDesigner::State::measureClearance(const Region& region, Curve& curve) const {
    std::vector<Triangle> avoided;
    for (const int f : region) {
        avoided.push_back(surface.faces()[at(f)]);
    }
    const TriangleTree avoidedTree(surface.vertices(), avoided);
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
        data.controlPoints.push_back(base->frame.toUser(curve.controls.row(c).transpose()));
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
)
    : state_(std::make_unique<State>(std::move(mesh), options, progress, store)) {}

CurveDesigner::~CurveDesigner() = default;
CurveDesigner::CurveDesigner(CurveDesigner&&) noexcept = default;
CurveDesigner& CurveDesigner::operator=(CurveDesigner&&) noexcept = default;

const Surface& CurveDesigner::surface() const {
    return state_->surface;
}

const StageSeconds& CurveDesigner::seconds() const {
    return state_->seconds;
}

const ShellSummary& CurveDesigner::shell() const {
    return state_->summary;
}

ShellLayers CurveDesigner::shellLayers() const {
    return makeShellLayers(state_->obtained.build.shell, state_->base->frame);
}

Curve CurveDesigner::design(
    const std::vector<Vec3>& picks,
    const SolverOptions& options,
    const SamplingOptions& sampling,
    const Guidance& guidance,
    const Progress& progress
) const {
    options.validate();
    sampling.validate();
    const State& state = *state_;
    const std::vector<double> vertexCosts = state.checkedCosts(guidance.field, options.fieldCost);
    const std::vector<SurfacePoint> located =
        locatePicks(state.surface, state.tree, picks, options.closed);
    state.refuseBlockedPicks(located);
    const Region region = state.regionOf(guidance.avoid);
    const std::optional<Obstacles> obstacles = state.obstaclesOf(region, options);
    if (obstacles) {
        refuseAvoidedPicks(state.surface, *obstacles, located);
    }
    const auto [problem, solution] = state.solveCurve(
        located, options, {guidance.field, vertexCosts, obstacles ? &*obstacles : nullptr}, progress
    );
    if (!std::isfinite(solution.report.maxDistance)) {
        refuseLostCurve(solution.report.status);
    }

    Stopwatch watch;
    Curve curve;
    curve.polyline =
        state.polylineOf(problem, solution.curve.space, solution.curve.controls, sampling);
    curve.spline = state.exportSpline(solution.curve, problem);
    curve.report = solution.report;
    if (obstacles) {
        requireClear(state.surface, curve.polyline, *obstacles);
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
    const auto degree = static_cast<std::ptrdiff_t>(data.degree);
    const SplineSpace space(
        data.degree,
        data.closed,
        std::vector<double>(data.knots.begin() + degree, data.knots.end() - degree)
    );
    ControlPoints controls(space.controlCount(), 3);
    for (int c = 0; c < space.controlCount(); ++c) {
        controls.row(c) = state.base->frame.toUnit(data.controlPoints[at(c)]).transpose();
    }
    std::vector<PickConstraint> picks;
    for (std::size_t i = 0; i < data.pickParameters.size(); ++i) {
        const SurfacePoint& point = curve.polyline.surfacePoints[at(curve.polyline.picks[i])];
        picks.push_back({point, state.base->position(point), data.pickParameters[i]});
    }
    SolverOptions options;
    options.degree = data.degree;
    options.closed = data.closed;
    CurveProblem problem = state.makeProblem(options, std::move(picks), {});
    const std::optional<Obstacles> obstacles = state.obstaclesOf(state.regionOf(avoid), options);
    problem.obstacles = obstacles ? &*obstacles : nullptr;
    SurfacePolyline line = state.polylineOf(problem, space, controls, sampling);
    if (obstacles) {
        requireClear(state.surface, line, *obstacles);
    }
    return line;
}

}  // namespace bspline_curve
