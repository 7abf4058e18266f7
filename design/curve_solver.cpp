// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/curve_solver.h"

#include "bspline_curve/error.h"
#include "bspline_curve/progress.h"
#include "bspline_curve/spline.h"
#include "design/curve_ladder.h"
#include "design/faired_path.h"
#include "design/overruns.h"
#include "design/path_shape.h"
#include "design/warm_start.h"
#include "shell/shell_boundary.h"
#include "solver/cellwise_solver.h"
#include "solver/paper/paper_variant.h"
#include "utility/stopwatch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace bspline_curve {
namespace {

struct StrategyConstants {
    /// Share of the progress for the field as strong as it was asked for, where it may be too
    /// strong.
    double firstShare = 0.9;
    /// Of that: for an attempt from another curve; of what is left, up to the end of
    /// attempts without a shell, and of attempts that need a shell.
    double startShare = 0.2, nearbyShare = 0.5, cellsShare = 0.95;
    /// Of what needs the shell: up to its end, and of attempts at samples in it.
    double builtShare = 0.5, sampledShare = 0.7;
    /// Of attempts at samples: up to the end of the loose one.
    double looseShare = 0.5;
    /// First weights for tight fits, as stiffnesses of stiffStart(): each is tried in turn.
    std::array<double, 3> stiffnesses = {5e7, 5e9, 5e11};
    /// Chords of paths for tight fits lie within so many tolerances of the surface. With more,
    /// curves bend more, and fewer of them are solved at samples.
    double chordTolerances = 0.1;
    /// Faces that feet are sought on, in all attempts at samples together: so many, and for each
    /// pick. Usual curves through few picks take less than a tenth of them.
    double mostWork = 2e5, mostWorkPerPick = 2e5;
    /// Shares of the field by which paths follow it, cell by cell: less where no spline along them
    /// stays in the shell.
    std::array<double, 3> guideShares = {1.0, 0.25, 0.0};
    /// A field must not draw an open curve past its ends so far, relative to the chord to the pick
    /// beside it, beyond so many times what its path does: less is hardly seen, and round a limb
    /// the path does so too.
    double mostOverrun = 0.02, overrunOfPath = 2.0;
    /// Of faired paths from the boundary, in distance tolerances: splines are off by one sometimes.
    double clearance = 2.0;
    /// It has these shares of its weight then, one after the other: most curves need a quarter or
    /// less than is left of a usual field, and each attempt costs as much as the first.
    std::array<double, 2> weakerShares = {0.25, 1.0 / 256.0};
    /// Under a field so strong (see fieldStrength()) half is left of fairing, and with less than
    /// this left none is tried.
    double fairingField = 1e-4, leastFairing = 0.01;
};

constexpr StrategyConstants kStrategy;

// In the shell's frame.
double distanceToleranceOf(const PreparedSurface& prepared, const SolverOptions& options) {
    return options.distanceTolerance *
           std::max(prepared.surface().averageEdgeLength(), prepared.finestEdge()) /
           prepared.extended()->frame.scale;
}

bool areSame(const InitialPath& first, const InitialPath& second) {
    using Point = InitialPath::Point;
    return std::ranges::equal(first.points, second.points, [](const Point& a, const Point& b) {
        return a.parameter == b.parameter && a.point.face == b.point.face &&
               a.position == b.position;
    });
}

// Along a spline that has been traced: where it crosses edges, and its picks.
PickPath pathAlong(const CurveProblem& problem, const CurveTrace& trace) {
    const ExtendedSurface& extended = *problem.extended;
    PickPath result;
    result.picks = problem.picks;
    std::vector<InitialPath::Point>& points = result.path.points;
    for (const PickConstraint& pick : result.picks) {
        points.push_back({pick.parameter, pick.point, pick.position});
    }
    if (problem.options.closed) {
        points.push_back({1.0, result.picks.front().point, result.picks.front().position});
    }
    const auto picks = std::ssize(points);
    for (const EdgeCrossing& crossing : progressOf(trace).crossings) {
        if (crossing.parameter > 0.0 && crossing.parameter < 1.0) {
            points.push_back(
                {crossing.parameter, crossing.point, extended.position(crossing.point)}
            );
        }
    }
    const auto isBefore = [](const InitialPath::Point& a, const InitialPath::Point& b) {
        return a.parameter < b.parameter;
    };
    std::inplace_merge(points.begin(), points.begin() + picks, points.end(), isBefore);
    return result;
}

}  // namespace

CurveProblem makeProblem(
    const PreparedSurface& prepared, const SolverOptions& options, std::vector<PickConstraint> picks
) {
    const Surface& surface = prepared.surface();
    const double scale = prepared.extended()->frame.scale;
    CurveProblem problem;
    problem.extended = prepared.extended().get();
    problem.patches = &prepared.patches();
    problem.picks = std::move(picks);
    problem.options = options;
    problem.variant = &paperVariant();
    problem.averageEdgeLength = surface.averageEdgeLength() / scale;
    problem.distanceTolerance = distanceToleranceOf(prepared, options);
    problem.chordLength = polygonLength(problem.picks, options.closed);
    return problem;
}

Solved CurveSolver::solve(const Progress& progress) const {
    Stopwatch watch;
    const double shellBefore = prepared_.seconds().wholeShell;
    const bool isPulled = mayTurnBack();
    Solved solved = solveInTurn(isPulled ? partOf(progress, 0.0, kStrategy.firstShare) : progress);
    CurveSolver weaker(*this);
    double share = 1.0;
    const std::size_t count = kStrategy.weakerShares.size();
    for (std::size_t i = 0; isPulled && i < count && turnsBack(solved); ++i) {
        share = kStrategy.weakerShares[i];
        weaker.options_.fieldWeight = share * options_.fieldWeight;
        const Progress again = partOf(progress, kStrategy.firstShare, 1.0);
        solved = weaker.solveInTurn(stepOf(again, i, count));
    }
    solved.solution.report.fieldShare = share;
    auto& seconds = solved.solution.report.seconds;
    seconds.shell = prepared_.seconds().wholeShell - shellBefore;
    const double own = seconds.path + seconds.initial + seconds.minimise + seconds.knots;
    seconds.failedAttempts = std::max(0.0, watch.lap() - seconds.shell - own);
    return solved;
}

// Open curves under a field; not with the paper's samples, whose field is weak.
bool CurveSolver::mayTurnBack() const {
    return !options_.closed && !context_.field.vertexCosts.empty() && options_.fieldWeight > 0.0 &&
           options_.quadrature != Quadrature::Samples;
}

bool CurveSolver::turnsBack(const Solved& solved) const {
    const auto reaches = [](const AtEnds<double>& overruns) {
        return std::ranges::max(overruns) > kStrategy.mostOverrun;
    };
    const SplineCurve& spline = solved.solution.curve;
    const Way curve = [&](double t) { return spline.space.evaluate(spline.controls, t); };
    const std::vector<PickConstraint>& picks = solved.problem.picks;
    if (!reaches(overrunsOf(curve, picks, arrivalsOf(curve, picks)))) {
        return false;  // whatever way its path comes
    }
    const PickPath along = pathRound({}, context_.field.travel(options_, 1.0), PathKind::Quick);
    const Way path = [&](double t) { return along.path.positionAt(t); };
    const AtEnds<Vec3> arrivals = arrivalsOf(path, along.picks);
    AtEnds<double> overruns = overrunsOf(curve, picks, arrivals);
    const AtEnds<double> ofPath = overrunsOf(path, along.picks, arrivals);
    for (const int end : {0, 1}) {
        overruns[end] -= kStrategy.overrunOfPath * ofPath[end];
    }
    return reaches(overruns);
}

// The cheapest way first:
// 1. at samples, from a curve through picks nearby, where one is given: a few steps;
// 2. at samples along the fibres, without a shell (see relaxOver);
// 3. where that is not for this curve, or it has faces to avoid, in the shell of the whole surface:
//    at samples where such a shell was asked for, else cell by cell, each iterate inside;
// 4. without relaxing anything, along a shortest path.
Solved CurveSolver::solveInTurn(const Progress& progress) const {
    const Progress begin = partOf(progress, 0.0, kStrategy.startShare);
    if (std::optional<Solved> solved = solveFromStart(begin)) {
        return std::move(*solved);
    }
    const Progress rest =
        partOf(progress, context_.start != nullptr ? kStrategy.startShare : 0.0, 1.0);
    if (isLocal()) {
        if (std::optional<Solved> solved =
                relaxOver(nullptr, partOf(rest, 0.0, kStrategy.nearbyShare))) {
            return std::move(*solved);
        }
    }
    std::optional<Solved> inShell;
    if (needsShell()) {
        inShell = solveInShell(partOf(rest, kStrategy.nearbyShare, kStrategy.cellsShare));
        if (inShell && inShell->solution.report.usable) {
            return std::move(*inShell);
        }
    }
    Solved tight = solveTightly(partOf(rest, kStrategy.cellsShare, 1.0));
    const bool isInside = inShell && std::isfinite(inShell->solution.report.maxDistance);
    return isInside && !tight.solution.report.usable ? std::move(*inShell) : std::move(tight);
}

// How much the path of least bending has to say: all without a field, less the stronger it is, and
// nothing beside a usual one, which bends curves itself.
double CurveSolver::fairedStrength() const {
    if (options_.fairness != Fairness::Curvature) {
        return 0.0;
    }
    CurveProblem problem;
    problem.options = options_;
    problem.fieldCosts = context_.field.costs;
    if (!hasPull(problem)) {
        return 1.0;
    }
    const double ratio = fieldStrength(problem) / kStrategy.fairingField;
    const double strength = 1.0 / (1.0 + ratio * ratio);
    return strength > kStrategy.leastFairing ? strength : 0.0;
}

// Of a faired path from the boundary: the spline beside it is not to run past that.
double CurveSolver::clearance() const {
    return kStrategy.clearance * distanceToleranceOf(prepared_, options_);
}

// Along the path of least bending. `unfaired`: the problem along `path`.
std::optional<Solved> CurveSolver::relaxFaired(
    const PickPath& path,
    const CurveProblem& unfaired,
    std::optional<SampledStart> start,
    double& work
) const {
    if (!isFaired()) {
        return std::nullopt;
    }
    const std::optional<PickPath> faired =
        fairedPath(*prepared_.extended(), &prepared_.patches(), path, options_, clearance());
    if (!faired) {
        return std::nullopt;
    }
    CurveProblem problem = problemOn(*faired, unfaired.shell, unfaired.progress);
    hold(*faired, problem);
    if (!hasPull(problem)) {
        start.reset();  // the path is nearer, and the curve before may have no knots to spare
    }
    return relaxed(std::move(problem), faired->path, std::move(start), work);
}

PickPath CurveSolver::quickPath() const {
    return pathRound({}, context_.field.travel(options_, 1.0), PathKind::Quick);
}

std::optional<PickPath> CurveSolver::pathNear(std::span<const PickLeeway> leeways) const {
    const PickPath quick = quickPath();
    const CurveProblem problem = problemOn(quick, nullptr, {});
    PathField field;
    if (hasPull(problem)) {
        field = {problem.field, options_.fieldCost, fieldWeight(problem)};
    }
    return fairedPath(
        *prepared_.extended(), &prepared_.patches(), quick, options_, clearance(), leeways, field
    );
}

std::optional<Solved> CurveSolver::solveAlong(
    const PickPath& path, std::span<const int> passed, const Progress& progress
) const {
    if (!isLocal()) {
        return std::nullopt;
    }
    Stopwatch watch;
    PickPath own{path.path, {}};
    for (const int pick : passed) {
        own.picks.push_back(path.picks[pick]);
    }
    CurveProblem problem = problemOn(own, nullptr, progress);
    problem.chordLength = polygonLength(path.picks, options_.closed);
    for (const PickConstraint& pick : path.picks) {
        problem.nearParameters.push_back(pick.parameter);
    }
    if (isFaired()) {
        hold(own, problem);
    }
    double work = workAtSamples();
    std::optional<Solved> solved = relaxed(std::move(problem), own.path, {}, work);
    if (solved) {
        auto& seconds = solved->solution.report.seconds;
        seconds.failedAttempts =
            std::max(0.0, watch.lap() - seconds.initial - seconds.minimise - seconds.knots);
    }
    return solved;
}

// Makes a problem's curve that of least bending.
void CurveSolver::hold(const PickPath& faired, CurveProblem& problem) const {
    problem.faired = fairedShapeOf(faired, options_, problem.chordLength);
    problem.faired.strength = fairedStrength();
    if (hasPull(problem)) {
        problem.faired.stiffness = 0.0;  // it would hold the curve against the field
    }
}

// Where attempts at samples without one are none, or must not be the only ones.
bool CurveSolver::needsShell() const {
    CurveProblem problem;
    problem.options = options_;
    problem.fieldCosts = context_.field.costs;
    return !isLocal() || context_.obstacles != nullptr || !isForSamples(problem);
}

// Nothing where picks lie in faces that the shell leaves out, or have no way between them round
// these, or where no curve stays in the shell.
std::optional<Solved> CurveSolver::solveInShell(const Progress& progress) const {
    const ObtainedShell& whole = prepared_.wholeShell(partOf(progress, 0.0, kStrategy.builtShare));
    const std::vector<int>& blockedFaces = whole.build.report.blockedFaces;
    if (arePicksIn(blockedFaces)) {
        return std::nullopt;
    }
    try {
        if (!isLocal()) {
            if (std::optional<Solved> solved = relaxOver(
                    &whole, partOf(progress, kStrategy.builtShare, kStrategy.sampledShare)
                )) {
                return solved;
            }
        }
        return solveInCells(whole, partOf(progress, kStrategy.sampledShare, 1.0));
    } catch (const InputError& error) {
        const bool isNoWay = error.code() == InputErrorCode::SelfIntersection ||
                             error.code() == InputErrorCode::NoPath;
        if (!isNoWay || blockedFaces.empty()) {
            throw;
        }
        return std::nullopt;
    }
}

Solved CurveSolver::solveTightly(const Progress& progress) const {
    Stopwatch lap;
    report(progress, 0.0, "following a shortest path");
    const PickPath path = pathRound({}, context_.field.travel(options_, 1.0), PathKind::OnSurface);
    CurveProblem problem = problemOn(path, nullptr, {});
    const double pathSeconds = lap.lap();
    Solution solution = tightAlong(prepared_, problem, path.path);
    solution.report.seconds.path = pathSeconds;
    return {std::move(problem), std::move(solution)};
}

PickPath CurveSolver::pathRound(
    std::span<const int> blockedFaces, const FieldTravel& travel, PathKind kind
) const {
    PickPath path = makePickPath(
        prepared_.surface(),
        *prepared_.extended(),
        picks_,
        options_.closed,
        {blockedFaces,
         travel,
         context_.obstacles,
         &prepared_.patches(),
         kind,
         kStrategy.chordTolerances * distanceToleranceOf(prepared_, options_),
         side_,
         context_.pickNumbers}
    );
    setTangents(path);
    return path;
}

void CurveSolver::setTangents(PickPath& path) const {
    for (std::size_t i = 0; i < context_.tangents.size(); ++i) {
        path.picks[i].tangent = context_.tangents[i];
    }
}

CurveProblem CurveSolver::problemOn(
    const PickPath& path, const Shell* shell, const Progress& progress
) const {
    CurveProblem problem = makeProblem(prepared_, options_, path.picks);
    // Parameters are shares of the length.
    const double speed = context_.tangents.empty() ? 0.0 : path.path.length();
    for (PickConstraint& pick : problem.picks) {
        pick.speed = speed;
    }
    problem.shell = shell;
    problem.field = context_.field.values;
    problem.fieldCosts = context_.field.costs;
    problem.obstacles = context_.obstacles;
    problem.keepsKnots = context_.keepsKnots;
    problem.side = side_;
    problem.progress = progress;
    return problem;
}

// Nothing where there is no such curve, or none from there.
std::optional<Solved> CurveSolver::solveFromStart(const Progress& progress) const {
    if (context_.start == nullptr) {
        return std::nullopt;
    }
    const Curve& start = *context_.start;
    const SplineData& spline = start.spline;
    if (!start.report.isSampled || spline.degree != options_.degree ||
        spline.closed != options_.closed || spline.pickParameters.size() != picks_.size() ||
        !cornersOf(spline).empty()) {
        return std::nullopt;
    }
    std::optional<WarmStart> dragged = dragCurve(start, *prepared_.extended(), picks_);
    if (!dragged) {
        return std::nullopt;
    }
    setTangents(dragged->path);
    const Shell* const shell = isLocal() ? nullptr : &prepared_.wholeShell().build.shell;
    CurveProblem problem = problemOn(dragged->path, shell, progress);
    SampledStart begin{std::move(dragged->spline), start.report.rounds.back().alpha};
    double work = workAtSamples();
    if (isFaired()) {
        return relaxFaired(dragged->path, problem, std::move(begin), work);
    }
    return relaxed(std::move(problem), dragged->path.path, std::move(begin), work);
}

// At samples, in the shell given or along the fibres. Nothing where no attempt leads to a curve:
// 1. from a loose fit to the initial path, which bends least;
// 2. from tight fits: a loose one may slip through a thin part of the surface, or into a fold, and
//    does not find back, however large its weight of the distance becomes.
std::optional<Solved> CurveSolver::relaxOver(
    const ObtainedShell* whole, const Progress& progress
) const {
    Stopwatch lap;
    const FieldTravel travel = context_.field.travel(options_, 1.0);
    std::span<const int> blocked;
    const Shell* shell = nullptr;
    if (whole != nullptr) {
        blocked = whole->build.report.blockedFaces;
        shell = &whole->build.shell;
    }
    const PickPath quick = pathRound(blocked, travel, PathKind::Quick);
    const CurveProblem loose = problemOn(quick, shell, partOf(progress, 0.0, kStrategy.looseShare));
    if (!isForSamples(loose)) {
        return std::nullopt;
    }
    double pathSeconds = lap.lap();
    double work = workAtSamples();
    std::optional<Solved> solved = relaxFaired(quick, loose, {}, work);
    if (!solved) {
        solved = relaxed(loose, quick.path, {}, work);
        if (solved && solved->solution.trace && isFaired()) {
            // A curve that is relaxed starts nearer to the fair one.
            const PickPath along = pathAlong(solved->problem, *solved->solution.trace);
            if (std::optional<Solved> again = relaxFaired(along, loose, {}, work)) {
                solved = std::move(again);
            }
        }
    }
    // With obstacles it is mostly these that are in its way.
    if (!solved && context_.obstacles == nullptr) {
        lap.lap();
        const PickPath close = pathRound(blocked, travel, PathKind::Close);
        pathSeconds += lap.lap();
        solved = relaxTightly(close, shell, partOf(progress, kStrategy.looseShare, 1.0), work);
    }
    if (solved) {
        solved->solution.report.seconds.path = pathSeconds;
    }
    return solved;
}

std::optional<Solved> CurveSolver::relaxTightly(
    const PickPath& path, const Shell* shell, const Progress& progress, double& work
) const {
    const std::size_t count = kStrategy.stiffnesses.size();
    for (std::size_t i = 0; i < count && work > 0.0; ++i) {
        CurveProblem problem = problemOn(path, shell, stepOf(progress, i, count));
        SampledStart start = stiffStart(problem, path.path, kStrategy.stiffnesses[i]);
        if (std::optional<Solved> solved =
                relaxed(std::move(problem), path.path, std::move(start), work)) {
            return solved;
        }
    }
    return std::nullopt;
}

double CurveSolver::workAtSamples() const {
    return kStrategy.mostWork + kStrategy.mostWorkPerPick * static_cast<double>(picks_.size());
}

// Along the fibres; where it crosses some, by the nearest points of its sheet.
std::optional<Solved> CurveSolver::relaxed(
    CurveProblem problem,
    const InitialPath& initialPath,
    std::optional<SampledStart> start,
    double& work
) const {
    if (!isForSamples(problem) || work <= 0.0) {
        return std::nullopt;
    }
    Solution solution = relaxAtSamples(problem, initialPath, std::move(start), work);
    work -= static_cast<double>(solution.work);
    problem.progress = {};  // it ends here
    if (!solution.report.usable && problem.shell == nullptr && problem.obstacles == nullptr) {
        if (std::optional<Solution> found = followedOnSheet(prepared_, problem, solution)) {
            solution = std::move(*found);
        }
    }
    return solution.report.usable ? std::optional(Solved{std::move(problem), std::move(solution)})
                                  : std::nullopt;
}

// Nothing where no spline along the paths stays in the shell.
std::optional<Solved> CurveSolver::solveInCells(
    const ObtainedShell& whole, const Progress& progress
) const {
    std::optional<ShellBoundary> boundary;
    if (options_.quadrature == Quadrature::Samples) {
        boundary.emplace(whole.build.shell);
    }
    Stopwatch lap;
    InitialPath failed;
    for (const double share : kStrategy.guideShares) {
        const FieldTravel travel = context_.field.travel(options_, share);
        if (share > 0.0 && travel.empty()) {
            continue;
        }
        const PickPath path =
            pathRound(whole.build.report.blockedFaces, travel, PathKind::OnSurface);
        if (areSame(path.path, failed)) {
            continue;  // first curves follow the path alone
        }
        CurveProblem problem = problemOn(path, &whole.build.shell, progress);
        problem.boundary = boundary ? &*boundary : nullptr;
        const double pathSeconds = lap.lap();
        if (std::optional<Solution> solution = solveCellwise(problem, path.path)) {
            problem.boundary = nullptr;  // it ends here
            problem.progress = {};
            solution->report.seconds.path = pathSeconds;
            return Solved{std::move(problem), std::move(*solution)};
        }
        failed = path.path;
    }
    return std::nullopt;
}

bool CurveSolver::arePicksIn(const std::vector<int>& faces) const {
    return std::ranges::any_of(picks_, [&](const SurfacePoint& pick) {
        return std::ranges::binary_search(faces, pick.face);
    });
}

}  // namespace bspline_curve
