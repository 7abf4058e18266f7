// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/algorithm1.h"

#include "bspline_curve/progress.h"
#include "solver/knot_insertion.h"
#include "solver/sample_rule.h"
#include "solver/solve_variant.h"
#include "utility/stopwatch.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace bspline_curve {
namespace {

struct SolveConstants {
    /// Share of the fresh directions in rounds: alone they can alternate between two states.
    double roundBlend = 0.5;
    /// A stall with more than this share of the energy left to gain is no end: weights and knots
    /// would grow in vain.
    double stuckDecrement = 0.1;
    /// The curve is at rest where fresh directions move no control point farther than this share of
    /// the tolerance; it converges linearly, about one digit per refresh.
    double restShare = 0.1;
    int mostRefreshes = 6;  ///< of the directions, at rest
    /// Of the progress, at the end of the rounds: distances fall geometrically, so the progress is
    /// their logarithm, and each round is a quarter of what is left.
    double roundsProgress = 0.9;
    double progressLeft = 0.75;
};

constexpr SolveConstants kSolve;

class Algorithm1 {
public:
    Algorithm1(
        const CurveProblem& problem,
        Energy& energy,
        const EnergyWeights& firstWeights,
        const SolvePolicy& policy
    )
        : problem_(problem),
          energy_(energy),
          policy_(policy),
          weights_(firstWeights),
          roundGoal_(policy.round),
          stopRule_(policy.givesUp),
          variant_(variantOf(problem).rounds(problem)) {
        report_.knotsFirst = knotCount();
    }

    Solution run() {
        for (round_ = 0;
             round_ < problem_.options.maxRounds && !isOverBudget(energy_, policy_.newton);
             ++round_) {
            const double left = std::pow(kSolve.progressLeft, round_);
            bspline_curve::report(
                problem_.progress, kSolve.roundsProgress * (1.0 - left), "minimising"
            );
            const MinimiseResult minimum = minimiseRound();
            const double largestHeight = distance_.largestHeight;
            std::vector<double> breaks = chooseBreaks(minimum);
            const bool isSettled = breaks == energy_.space().breaks();
            addRound(minimum);
            if (isSettled) {
                energy_.makeExact();  // what is left lies between the samples
            }
            double ratio = distanceRatio();
            if (isSettled && ratio < policy_.schedule.nearShare &&
                variant_->arePicksNear(energy_)) {
                const SolveStatus status = rest();
                if (distance_.largest < problem_.distanceTolerance) {
                    report_.status = status;
                    report_.usable = true;
                    break;
                }
                if (policy_.tracesAtRestOnly) {
                    if (stopRule_.isHalvingInVain(knotCount())) {
                        break;
                    }
                    breaks = halveFarSpans();
                } else {
                    ratio = distanceRatio();
                }
            } else if (isInVain(ratio)) {
                break;
            }
            EnergyWeights next = weights_;
            next.alpha = policy_.schedule.next(weights_.alpha, ratio);
            variant_->adjustNext(weights_, minimum.value.terms, next);
            if (breaks == energy_.space().breaks() && next.alpha <= weights_.alpha &&
                next.beta <= weights_.beta) {
                report_.status = SolveStatus::KnotLimit;
                break;
            }
            weights_ = next;
            insertKnots(std::move(breaks));
            variant_->setBarrier(energy_, largestHeight, weights_);
        }
        return finish();
    }

private:
    [[nodiscard]] double distanceRatio() const {
        return distance_.largest / problem_.distanceTolerance;
    }

    [[nodiscard]] int knotCount() const {
        return static_cast<int>(energy_.space().knotVector().size());
    }

    [[nodiscard]] bool isInVain(double ratio) {
        const bool isNear = ratio < policy_.schedule.nearShare;
        return (!isNear && weights_.alpha > policy_.schedule.highest) ||
               stopRule_.isInVain(problem_, energy_, report_, isNear);
    }

    MinimiseResult minimiseTo(NewtonGoal goal) {
        goal.mostIterations = std::min(goal.mostIterations, problem_.options.maxIterations);
        MinimiseResult result =
            minimise(energy_, weights_, problem_.options.interpolation, policy_.newton, goal);
        for (IterationReport entry : result.iterations) {
            entry.round = round_;
            report_.iterations.push_back(entry);
        }
        report_.newtonIterations += static_cast<int>(result.iterations.size());
        if (policy_.meetsPicks && problem_.options.interpolation == Interpolation::Constraint) {
            ControlPoints controls = energy_.controls();
            energy_.picks().meet(controls);
            energy_.setControls(controls);
        }
        if (problem_.options.fieldWeight > 0.0) {
            // What costs the same everywhere is not integrated.
            report_.fieldCost = fieldWeight(problem_) > 0.0 ? result.value.terms.external
                                                            : problem_.fieldCosts.least;
        }
        report_.fieldAtRest = !hasPull(problem_) || result.status == MinimiseStatus::Converged;
        report_.seconds.minimise += watch_.lap();
        return result;
    }

    // With the directions along the curve; once more exactly where it has left the shell between
    // two samples, or a kink of the rough energy holds it.
    MinimiseResult minimiseRound() {
        energy_.freezeDirections(kSolve.roundBlend);
        const ControlPoints before = energy_.controls();
        MinimiseResult result = minimiseTo(energy_.isRough() ? policy_.rough : roundGoal_);
        distance_ = energy_.measure();
        const bool isOutside = !std::isfinite(distance_.largest);
        if (energy_.isRough() && (isOutside || isStuck(result))) {
            if (isOutside) {
                energy_.setControls(before);
            }
            energy_.makeExact();
            return minimiseRound();
        }
        if (distanceRatio() >= policy_.schedule.nearShare && result.iterations.size() <= 1) {
            roundGoal_.decrement = std::min(roundGoal_.decrement, policy_.idleDecrement);
        }
        return result;
    }

    [[nodiscard]] static bool isStuck(const MinimiseResult& result) {
        return result.status == MinimiseStatus::LineSearchStalled &&
               result.iterations.back().decrement > kSolve.stuckDecrement * result.value.scale;
    }

    void addRound(const MinimiseResult& result) {
        report_.rounds.push_back(
            {weights_.alpha,
             weights_.beta,
             knotCount(),
             static_cast<int>(result.iterations.size()),
             result.status,
             distance_.largest / problem_.averageEdgeLength}
        );
    }

    [[nodiscard]] std::vector<double> chooseBreaks(const MinimiseResult& minimum) {
        const bool isNear = distanceRatio() < policy_.schedule.nearShare;
        if (std::optional<std::vector<double>> breaks =
                variant_->chooseBreaks(energy_, weights_, minimum.value.scale, isNear)) {
            return std::move(*breaks);
        }
        const KnotDemand gain = energy_.refinementGain();
        const bool isInVain =
            isNear && stopRule_.isRefiningInVain(minimum.value.total, gain.total, weights_);
        return gain.isNegligible || isInVain
                   ? energy_.space().breaks()
                   : halveLargest(energy_.space(), gain, shortestSpan(problem_.options));
    }

    // Minimises to the end, with frozen directions refreshed until they no longer move the curve,
    // which then meets the picks; measures the whole of it. A penalty's minimum that had to move
    // for the picks is none any more.
    SolveStatus rest() {
        const SolveStatus status = comeToRest();
        const double moved = variant_->meetPicks(energy_, policy_.newton);
        if (std::optional<TracedSpline> thinned = energy_.withFewerKnots()) {
            thinned_ = std::move(thinned->curve);
            distance_ = std::move(thinned->distance);
            report_.seconds.knots += watch_.lap();
        } else {
            distance_ = energy_.trace();
        }
        return moved < kSolve.restShare * problem_.distanceTolerance ? status
                                                                     : SolveStatus::DistanceReached;
    }

    SolveStatus comeToRest() {
        double movedBefore = std::numeric_limits<double>::infinity();
        double blend = 1.0;
        int iterationsLeft = policy_.restIterations;
        const auto isMinimal = [&](double decrement) {
            NewtonGoal goal = policy_.rest;
            goal.decrement = decrement;
            goal.mostIterations = std::min(goal.mostIterations, iterationsLeft);
            const MinimiseResult result = minimiseTo(goal);
            iterationsLeft -= static_cast<int>(result.iterations.size());
            return result.status == MinimiseStatus::Converged;
        };
        for (int refresh = 0; refresh < kSolve.mostRefreshes; ++refresh) {
            const ControlPoints before = energy_.controls();
            energy_.freezeDirections(blend);
            if (!isMinimal(policy_.rest.decrement)) {
                break;
            }
            if (policy_.fineDecrement == 0.0) {
                return SolveStatus::Converged;
            }
            const double moved = (energy_.controls() - before).rowwise().norm().maxCoeff();
            if (moved < kSolve.restShare * problem_.distanceTolerance) {
                return isMinimal(policy_.fineDecrement) ? SolveStatus::Converged
                                                        : SolveStatus::DistanceReached;
            }
            if (moved > movedBefore) {
                blend = kSolve.roundBlend;
            }
            movedBefore = moved;
        }
        return SolveStatus::DistanceReached;
    }

    [[nodiscard]] std::vector<double> halveFarSpans() const {
        const SplineSpace& space = energy_.space();
        const std::vector<double>& perSpan = distance_.perSpan;
        std::vector<char> marked(space.spanCount(), 0);
        for (int span = 0; span < space.spanCount(); ++span) {
            // Beyond the span on which the curve leaves the shell nothing is known.
            const bool isKnown = span == 0 || std::isfinite(perSpan[span - 1]);
            marked[span] = perSpan[span] >= problem_.distanceTolerance && isKnown ? 1 : 0;
        }
        return halveSpans(space, marked, shortestSpan(problem_.options));
    }

    void insertKnots(std::vector<double> breaks) {
        if (breaks != energy_.space().breaks()) {
            energy_.insertKnots(
                {problem_.options.degree, problem_.options.closed, std::move(breaks)}
            );
        }
        report_.seconds.knots += watch_.lap();
    }

    [[nodiscard]] Solution finish() {
        if (!report_.usable && !policy_.tracesAtRestOnly) {
            variant_->meetPicks(energy_, policy_.newton);
            distance_ = energy_.trace();
            report_.usable = distance_.largest < problem_.distanceTolerance;
            const bool isStopped = round_ < problem_.options.maxRounds;
            if (report_.usable &&
                (isStopped || problem_.options.interpolation == Interpolation::Penalty)) {
                report_.status = SolveStatus::DistanceReached;
            }
        }
        SplineCurve curve =
            thinned_ ? std::move(*thinned_) : SplineCurve{energy_.space(), energy_.controls()};
        const PickConstraints picks(curve.space, interpolationRows(curve.space, problem_.picks));
        report_.knotsLast = static_cast<int>(curve.space.knotVector().size());
        report_.maxPickGap = picks.residual(curve.controls).lpNorm<Eigen::Infinity>();
        report_.maxDistance = distance_.largest / problem_.averageEdgeLength;
        report_.seconds.minimise += watch_.lap();
        Solution solution{std::move(curve), std::move(report_), {}, energy_.work()};
        if (solution.report.usable) {
            solution.trace = std::move(distance_.trace);
        }
        return solution;
    }

    const CurveProblem& problem_;
    Energy& energy_;
    const SolvePolicy& policy_;
    EnergyWeights weights_;
    NewtonGoal roundGoal_;
    StopRule stopRule_;
    std::unique_ptr<RoundVariant> variant_;
    CurveDistance distance_;              // of curve and surface, in the shell's frame
    std::optional<SplineCurve> thinned_;  // the curve at rest, without needless knots
    int round_ = 0;
    SolveReport report_;
    Stopwatch watch_;
};

}  // namespace

Solution solve(
    const CurveProblem& problem,
    Energy& energy,
    const EnergyWeights& firstWeights,
    const SolvePolicy& policy
) {
    return Algorithm1(problem, energy, firstWeights, policy).run();
}

}  // namespace bspline_curve
