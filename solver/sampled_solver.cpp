// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/sampled_solver.h"

#include "solver/algorithm1.h"
#include "solver/obstacles.h"
#include "solver/sampled_energy.h"
#include "solver/solve_variant.h"
#include "utility/stopwatch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace bspline_curve {
namespace {

// Shares of the surface's bending that are tried in turn until the Hessian is positive.
constexpr std::array<double, 4> kTurningShares = {1.0, 0.5, 0.25, 0.0};

// Whether what the curve avoids is too far away to push it anywhere.
bool isClear(const CurveProblem& problem, const Solution& solution) {
    const Obstacles* const obstacles = problem.obstacles;
    return obstacles == nullptr || std::ranges::all_of(facesPassed(solution), [&](int face) {
               return obstacles->isFar(face);
           });
}

// Whether it is drawn along a path of least bending that no field bends further.
bool isAlongFaired(const CurveProblem& problem) {
    return !problem.faired.empty() && !hasPull(problem);
}

// A weight of the distance that holds a curve as fast on every resolution.
double alphaOf(const CurveProblem& problem, double stiffness) {
    const double share = heightUnitOf(problem) / problem.chordLength;
    return stiffness * share * share;
}

}  // namespace

bool isForSamples(const CurveProblem& problem) {
    const SolverOptions& options = problem.options;
    return options.quadrature == Quadrature::FootPoints && !needsVariant(options) &&
           options.tension <= kSampled.highestTension &&
           fieldStrength(problem) <= kSampled.strongestField;
}

WeightSchedule sampledSchedule() {
    WeightSchedule schedule;
    schedule.nearShare = kSampled.nearShare;
    schedule.overshoot = kSampled.overshoot;
    schedule.mostFactor = kSampled.mostAlphaFactor;
    schedule.highest = kSampled.highestAlpha;
    return schedule;
}

SolvePolicy sampledPolicy(const CurveProblem& problem, double startAlpha) {
    const bool hasField = fieldWeight(problem) > 0.0;
    SolvePolicy policy;
    policy.schedule = sampledSchedule();
    policy.schedule.returnTo = startAlpha;
    policy.givesUp = true;
    policy.newton.negativeShares = kTurningShares;
    policy.newton.mostDampings = hasField ? 0 : kSampled.mostDampings;
    policy.newton.takesLastStep = true;
    policy.newton.hasShortSteps = hasField;
    policy.round.decrement = policy.idleDecrement = kSampled.roundDecrement;
    policy.round.mostIterations = kSampled.mostSteps;
    policy.round.gainlessSteps = hasField ? kSampled.gainlessSteps : 0;
    policy.rest.decrement = kSampled.restDecrement;
    policy.rest.mostIterations = kSampled.mostRestSteps;
    policy.rest.keptPromise = kSampled.keptPromise;
    policy.round.leastStep = policy.rest.leastStep = kSampled.leastStep;
    policy.tracesAtRestOnly = true;
    return policy;
}

double heightUnitOf(const CurveProblem& problem) {
    return kSampled.heightUnit * problem.distanceTolerance;
}

// A field lifts curves as well.
double firstAlphaOf(const CurveProblem& problem) {
    const double stiffness = isAlongFaired(problem)
                                 ? kSampled.fairedStiffness * kSampled.firstStiffness
                                 : kSampled.firstStiffness;
    const double byField = 1.0 + kSampled.stiffnessByStrength * fieldStrength(problem);
    return std::max(
        kSampled.leastFirstAlpha * byField,
        alphaOf(problem, std::max(stiffness, kSampled.firstFieldStiffness * byField))
    );
}

SplineCurve looseFit(const CurveProblem& problem, const InitialPath& initialPath) {
    if (isAlongFaired(problem)) {
        return fitLoosely(problem, initialPath, problem.chordLength * kSampled.firstFairedDistance);
    }
    const double share = std::min(1.0, fieldStrength(problem));
    return fitLoosely(
        problem,
        initialPath,
        problem.chordLength * std::lerp(kSampled.firstDistance, kSampled.firstFieldDistance, share)
    );
}

SampledStart stiffStart(
    const CurveProblem& problem, const InitialPath& initialPath, double stiffness
) {
    return {
        fitLoosely(problem, initialPath, kSampled.tightDistance * problem.distanceTolerance),
        alphaOf(problem, stiffness),
        true
    };
}

Solution relaxAtSamples(
    const CurveProblem& problem,
    const InitialPath& initialPath,
    std::optional<SampledStart> start,
    double mostWork
) {
    Stopwatch watch;
    const double startAlpha = start ? start->alpha : 0.0;
    const bool isAgain = start && start->isTight;  // a first attempt has failed
    SampledEnergy energy(
        problem,
        start ? std::move(start->curve) : looseFit(problem, initialPath),
        initialPath,
        heightUnitOf(problem),
        isAgain ? SampledIntegrals::kMostSegments : SampledIntegrals::kUsualSegments
    );
    const double initial = watch.lap();
    EnergyWeights weights;
    weights.alpha = std::max(firstAlphaOf(problem), kSampled.restartShare * startAlpha);
    SolvePolicy policy = sampledPolicy(problem, startAlpha);
    policy.newton.mostWork = mostWork;
    Solution solution = solve(problem, energy, weights, policy);
    solution.report.isSampled = true;
    solution.report.seconds.initial = initial;
    if (solution.report.usable && !isClear(problem, solution)) {
        solution.report.usable = false;
        solution.trace.reset();
    }
    return solution;
}

std::optional<Solution> solveSampled(
    const CurveProblem& problem, const InitialPath& initialPath, std::optional<SampledStart> start
) {
    if (!isForSamples(problem)) {
        return std::nullopt;
    }
    Solution solution = relaxAtSamples(problem, initialPath, std::move(start));
    return solution.report.usable ? std::optional(std::move(solution)) : std::nullopt;
}

}  // namespace bspline_curve
