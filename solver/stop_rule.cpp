// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/stop_rule.h"

#include <algorithm>
#include <limits>

namespace bspline_curve {
namespace {

struct StopConstants {
    /// A curve is stuck that is farther away than this, in tolerances,
    double farRatio = 3.0;
    /// which so many rounds have not brought nearer
    int stuckRounds = 2;
    /// than to this share of its distance,
    double stuckShare = 0.8;
    /// after its weight of the distance has become so many times as large: on fine meshes a usual
    /// curve may stay far away for long.
    double stuckGrowth = 9e3;
    /// Knots multiply in vain where they become so many times as many on a curve that is near, some
    /// on spans shorter than the tolerance; usual curves come to rest with up to twice as many.
    double mostKnotGrowth = 2.25;
    double mostQuadraticKnotGrowth = 5.0;  ///< of quadratic splines, which need more
    /// Where spans are halved that leave the tolerance between samples, knots become a few more.
    /// Where they become so many times as many, it is the fibres there that are of no use.
    double mostHalving = 2.0;
    /// Knots are also in vain after so many rounds in which a curve was near and Newton's method
    /// did not end: it is pressed against what it avoids, and each further knot presses anew.
    int mostUnfinishedRounds = 8;
    /// Knots that lower the energy by less than this share of what they promised, so many rounds in
    /// turn, are in vain.
    double leastKept = 0.05;
    int mostBrokenPromises = 3;
};

constexpr StopConstants kStop;

// On the wrong side of a thin part a curve does not find back, however large its weight becomes.
bool isStuck(const CurveProblem& problem, const SolveReport& report) {
    const std::vector<RoundReport>& rounds = report.rounds;
    const RoundReport& last = rounds.back();
    const double tolerance = problem.distanceTolerance / problem.averageEdgeLength;
    return last.maxDistance > kStop.farRatio * tolerance && rounds.size() > kStop.stuckRounds &&
           last.alpha > kStop.stuckGrowth * rounds.front().alpha &&
           last.maxDistance >
               kStop.stuckShare * (rounds.end() - 1 - kStop.stuckRounds)->maxDistance;
}

bool areUnfinished(const SolveReport& report) {
    return std::ranges::none_of(
        report.rounds.end() - kStop.mostUnfinishedRounds,
        report.rounds.end(),
        [](const RoundReport& round) { return round.status == MinimiseStatus::Converged; }
    );
}

double shortestSpan(const Energy& energy) {
    double shortest = std::numeric_limits<double>::infinity();
    for (int span = 0; span < energy.space().spanCount(); ++span) {
        const PolynomialCurve curve = energy.space().polynomial(energy.controls(), span);
        shortest = std::min(shortest, (curve.at(1.0) - curve.at(0.0)).norm());
    }
    return shortest;
}

}  // namespace

bool StopRule::isHalvingInVain(int knots) {
    knotsAtRest_ = knotsAtRest_ > 0 ? knotsAtRest_ : knots;
    return knots > kStop.mostHalving * knotsAtRest_;
}

bool StopRule::isRefiningInVain(double energy, double promised, const EnergyWeights& weights) {
    const bool isComparable = promise_ && promise_->weights.alpha == weights.alpha &&
                              promise_->weights.beta == weights.beta;
    const bool isBroken =
        isComparable && promise_->energy - energy < kStop.leastKept * promise_->gain;
    brokenPromises_ = isBroken ? brokenPromises_ + 1 : 0;
    promise_ = Promise{.energy = energy, .gain = promised, .weights = weights};
    return brokenPromises_ >= kStop.mostBrokenPromises;
}

bool StopRule::isInVain(
    const CurveProblem& problem, const Energy& energy, const SolveReport& report, bool isNear
) {
    roundsNearby_ = isNear ? roundsNearby_ + 1 : 0;
    if (roundsNearby_ >= kStop.mostUnfinishedRounds && areUnfinished(report)) {
        return true;
    }
    if (!givesUp_) {
        return false;
    }
    if (!isNear) {
        knotsNearby_ = 0;
        return isStuck(problem, report);
    }
    const int knots = report.rounds.back().knots;
    knotsNearby_ = knotsNearby_ > 0 ? knotsNearby_ : knots;
    const double mostGrowth =
        problem.options.degree > 2 ? kStop.mostKnotGrowth : kStop.mostQuadraticKnotGrowth;
    return knots > mostGrowth * knotsNearby_ && shortestSpan(energy) < problem.distanceTolerance;
}

}  // namespace bspline_curve
