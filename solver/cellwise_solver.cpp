// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/cellwise_solver.h"

#include "projection/curve_distance.h"
#include "solver/algorithm1.h"
#include "solver/cellwise_energy.h"
#include "solver/shell_reach.h"
#include "solver/solve_variant.h"
#include "utility/stopwatch.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace bspline_curve {
namespace {

struct CellwiseConstants {
    /// First weight of E_dist, which is dimensionless, in a thin shell.
    double firstAlpha = 10.0;
    /// Weight of E_avoid: iterations hardly depend on it; with less, curves keep less of the
    /// margin.
    double avoidance = 3.0;
    /// Newton stops at these shares of the energy: in rounds with rough integrals; in the others,
    /// and at rest while frozen directions still change; and at last. With more in the rounds
    /// curves depend on the triangulation.
    double roughDecrement = 5e-3, roundDecrement = 1e-4, fineDecrement = 1e-6;
    /// The same under a field, where Newton crawls along edges at which the field's gradient jumps:
    /// the digits beyond these cost as many iterations as all before, and move nothing. Of a weak
    /// field, powers between: the weaker it is, the nearer to those without one.
    double fieldRoundDecrement = 1e-2, fieldFineDecrement = 1e-4;
    /// Iterations at rest under a field: strong ones still creep then.
    int fieldRestIterations = 15;
    /// At the paper's samples: cells between samples are not seen, so that the energy is not smooth
    /// enough for more digits.
    double sampledDecrement = 1e-3;
    int sampledRestIterations = 30;
    /// The line search gives up below this share of a step where energies are rough: they have
    /// kinks, at which it stalls, and less than half a step is not worth it.
    double leastRoughStep = 0.3;
    /// Spans that are integrated, in all evaluations together: so many, and for each pick. Of
    /// usable curves on meshes that people have, half take a thousandth of them, the slowest one
    /// half.
    double mostWork = 2e5, mostWorkPerPick = 5e4;
};

constexpr CellwiseConstants kCellwise;

// E_int of the geodesics between the picks: the tension term of no curve on the surface is less.
// Corners that are cut at lambda = 1 are a few per cent of it, and would not be seen beside it.
// Parameters follow the length of the initial path. 0 where the curve need not pass picks that the
// path passes: it may be shorter then.
double tensionFloor(const CurveProblem& problem, const InitialPath& initialPath) {
    if (!problem.nearParameters.empty()) {
        return 0.0;
    }
    const double ratio = initialPath.length() / problem.chordLength;
    return problem.options.tension * ratio * ratio;
}

// From one decrement to another as the field grows to the strength of usual bending.
double decrementUnderField(const CurveProblem& problem, double without, double with) {
    return without * std::pow(with / without, std::min(1.0, fieldStrength(problem)));
}

SolvePolicy policyFor(const CurveProblem& problem) {
    SolvePolicy policy;
    // In thin shells, steps by what is needed make curves depend more on the triangulation.
    policy.schedule.isGentle = !problem.shell->isFullResolution();
    policy.newton = cellwiseNewton();
    policy.newton.mostWork =
        kCellwise.mostWork + kCellwise.mostWorkPerPick * static_cast<double>(problem.picks.size());
    policy.rough.decrement = kCellwise.roughDecrement;
    policy.round.decrement =
        decrementUnderField(problem, kCellwise.roundDecrement, kCellwise.fieldRoundDecrement);
    policy.rest.decrement = kCellwise.roundDecrement;
    for (NewtonGoal* const goal : {&policy.rough, &policy.round, &policy.rest}) {
        goal->mostIterations = problem.options.maxIterations;
    }
    policy.rough.leastStep = kCellwise.leastRoughStep;
    policy.idleDecrement = kCellwise.roundDecrement;
    policy.fineDecrement =
        decrementUnderField(problem, kCellwise.fineDecrement, kCellwise.fieldFineDecrement);
    if (hasPull(problem)) {
        policy.restIterations = kCellwise.fieldRestIterations;
    }
    if (problem.options.quadrature == Quadrature::Samples) {
        policy.round.decrement = kCellwise.sampledDecrement;
        policy.rest.decrement = kCellwise.sampledDecrement;
        policy.restIterations = kCellwise.sampledRestIterations;
        policy.fineDecrement = 0.0;
    }
    policy.meetsPicks = true;
    return policy;
}

EnergyWeights firstWeights(const CurveProblem& problem, Energy& energy) {
    EnergyWeights weights;
    weights.alpha = kCellwise.firstAlpha;
    weights.avoidance = kCellwise.avoidance;
    variantOf(problem).rounds(problem)->adjustFirst(energy, energy.trace().largestHeight, weights);
    if (problem.options.distanceWeight == DistanceWeight::Adaptive) {
        return weights;
    }
    // E_dist goes with the square of the relative height, so a thick shell is softer. A strong
    // field must not press the first curve against top and bottom.
    const double reach = relativeReach(problem);
    weights.alpha *= reach * reach * (1.0 + fieldStrength(problem));
    return weights;
}

}  // namespace

Solution solveInShell(
    const CurveProblem& problem, const InitialPath& initialPath, SplineCurve first
) {
    CellwiseEnergy energy(problem, std::move(first), tensionFloor(problem, initialPath));
    const EnergyWeights weights = firstWeights(problem, energy);
    return solve(problem, energy, weights, policyFor(problem));
}

std::optional<Solution> solveCellwise(const CurveProblem& problem, const InitialPath& initialPath) {
    Stopwatch watch;
    std::optional<SplineCurve> first = makeFirstCurve(problem, initialPath);
    if (!first) {
        return std::nullopt;
    }
    const double initial = watch.lap();
    Solution solution = solveInShell(problem, initialPath, std::move(*first));
    solution.report.seconds.initial = initial;
    return solution;
}

}  // namespace bspline_curve
