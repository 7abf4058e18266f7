// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/relaxation.h"

#include "solver/curve_distance.h"
#include "solver/curve_tracer.h"
#include "solver/foot_energy.h"
#include "solver/knot_insertion.h"
#include "solver/point_terms.h"
#include "surface/stopwatch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

namespace bspline_curve {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

// Heights are measured in this many tolerances: in mean edge lengths with the default tolerance.
constexpr double kUnitInTolerances = 10.0;
// First weight of the distance, per squared length of the polygon of picks: the bending of usual
// curves, 10 to 400, then lifts them by 0.5 to 4 % of that, on every resolution. With a third of it
// curves over coarse meshes float so far above that directions change from step to step and Newton
// goes round in circles; with three times as much they stick to where they start, for a tenth more
// bending.
constexpr double kFirstStiffness = 3e5;
constexpr double kLeastFirstAlpha = 5.0;
// It grows by what is needed to come below the tolerance, as heights fall with a power of it.
// Growth by 4 and 6 at most takes more steps over 24 curves on 8 scans, for more bending.
constexpr double kAlphaFactor = 10.0;
constexpr double kLeastAlphaFactor = 1.5;
constexpr double kDistanceExponent = 1.5;
constexpr double kHighestAlpha = 1e9;
// Samples are brought so far below the tolerance that most curves keep it between them as well.
constexpr double kAimedShare = 0.8;

// Newton stops at this share of the energy while weights and knots still change, and at last. 0.001
// in place of either takes a fifth more steps, and bending stays the same.
constexpr double kRoundDecrement = 0.05;
constexpr double kRestDecrement = 1e-3;
// In one round, and at last: samples have kinks that the steps near the end wander between.
constexpr int kMaxSteps = 30;
constexpr int kMaxRestSteps = 6;
constexpr int kMaxHalvings = 8;
constexpr double kSufficientDecrease = 1e-4;
// Share of the surface's bending that is tried in turn until the Hessian is positive.
constexpr std::array<double, 4> kTurningShares = {1.0, 0.5, 0.25, 0.0};
// As in newtonStep().
constexpr double kConstraintWeight = 1e3;

// More knots no longer change the curve where bulges of all spans would lower the energy by less
// than this share. 0.02 gives 3 % more bending with a tenth fewer knots.
constexpr double kNegligibleGain = 0.01;

// With more tension little holds a curve between samples, and corners at picks want knots that
// bulges do not ask for.
constexpr double kHighestTension = 0.5;
// Stronger fields draw the samples into valleys that are narrower than the way between two samples.
constexpr double kStrongestField = 20.0;

// What belongs to one knot vector.
struct Stage {
    Stage(const CurveProblem& problem, SplineSpace splines, ControlPoints controls, double unit)
        : space(std::move(splines)),
          energy(problem, space, unit),
          system(space, interpolationRows(space, problem.picks)),
          now{std::move(controls),
              std::vector<FootPoint>(at(energy.sampleCount())),
              std::vector<FootFrame>(at(energy.sampleCount()))} {}

    SplineSpace space;
    FootEnergy energy;
    SplineSystem system;
    FootedSpline now;
};

bool isForFootPoints(const CurveProblem& problem) {
    const SolverOptions& options = problem.options;
    return options.quadrature == Quadrature::FootPoints &&
           options.initialCurve == InitialCurve::GeodesicFit &&
           options.barrierWidth == BarrierWidth::Full &&
           options.distanceWeight == DistanceWeight::Schedule &&
           options.interpolation == Interpolation::Constraint &&
           options.knotRule == KnotRule::EnergyAndDistance && options.tension <= kHighestTension &&
           fieldStrength(problem) <= kStrongestField;
}

// Whether what the curve avoids is too far away to push it anywhere.
bool isClear(const CurveProblem& problem, const SplineCurve& curve) {
    bool clear = true;
    if (problem.obstacles != nullptr) {
        traceCurve(
            problem,
            curve.space,
            curve.controls,
            [&](int, const PolynomialCurve&, const ShellCell& cell, double, double) {
                clear &=
                    problem.obstacles->isFar(cell.face) && !problem.obstacles->isAvoided(cell.face);
            },
            [](int, const PolynomialCurve&, const ShellCell&, const ShellCell&, double, int) {}
        );
    }
    return clear;
}

class Relaxer {
public:
    Relaxer(const CurveProblem& problem, const GuidePath& guide, const SplineCurve& first)
        : problem_(problem),
          options_(problem.options),
          finder_(*problem.base),
          tolerance_(options_.distanceTolerance * problem.averageEdgeLength),
          heightUnit_(kUnitInTolerances * tolerance_),
          alpha_(
              std::max(
                  kLeastFirstAlpha,
                  kFirstStiffness * std::pow(heightUnit_ / problem.chordLength, 2.0)
              )
          ),
          stage_(makeStage(first.space, first.controls)) {
        startOnGuide(guide);
        report_.knotsFirst = knotCount();
    }

    std::optional<Solution> run() {
        for (int round = 0; round < options_.maxRounds; ++round) {
            bspline_curve::report(problem_.progress, progressFraction(round), "minimising");
            steps_ = 0;
            descend(round, kRoundDecrement, kMaxSteps);
            const double ratio = energy().largestHeight(now()) / tolerance_;
            std::vector<double> breaks = chooseBreaks();
            const bool isSettled = breaks == space().breaks();
            addRound(ratio);
            if (isSettled && ratio < kAimedShare) {
                descend(round, kRestDecrement, kMaxRestSteps);
                if (isWithinTolerance(breaks)) {
                    return finish();
                }
                if (breaks == space().breaks()) {
                    return std::nullopt;  // no span can be halved any more
                }
            } else if (ratio >= kAimedShare) {
                if (alpha_ > kHighestAlpha) {
                    return std::nullopt;
                }
                alpha_ *= std::clamp(
                    std::pow(1.1 * ratio / kAimedShare, kDistanceExponent),
                    kLeastAlphaFactor,
                    kAlphaFactor
                );
            }
            insert(std::move(breaks));
        }
        return std::nullopt;
    }

private:
    [[nodiscard]] FootedSpline& now() { return stage_->now; }

    [[nodiscard]] const FootEnergy& energy() const { return stage_->energy; }

    [[nodiscard]] const SplineSpace& space() const { return stage_->space; }

    [[nodiscard]] int knotCount() const { return static_cast<int>(space().knotVector().size()); }

    [[nodiscard]] static double progressFraction(int round) {
        return 0.9 * (1.0 - std::pow(0.75, round));
    }

    [[nodiscard]] std::unique_ptr<Stage> makeStage(
        SplineSpace space, ControlPoints controls
    ) const {
        return std::make_unique<Stage>(
            problem_, std::move(space), std::move(controls), heightUnit_
        );
    }

    void startOnGuide(const GuidePath& guide) {
        std::size_t near = 0;
        for (int sample = 0; sample < energy().sampleCount(); ++sample) {
            const double t = energy().parameter(sample);
            while (near + 1 < guide.points.size() && guide.points[near + 1].parameter <= t) {
                ++near;
            }
            const SurfacePoint& point = guide.points[near].point;
            now().feet[at(sample)] = {point.face, point.barycentric[1], point.barycentric[2], 0.0};
        }
        energy().follow(finder_, now());
    }

    // Newton's method until a step promises less than this share of the energy.
    void descend(int round, double decrementShare, int mostSteps) {
        status_ = MinimiseStatus::IterationLimit;
        const int most = std::min(mostSteps, options_.maxIterations);
        for (int step = 0; step < most && status_ == MinimiseStatus::IterationLimit; ++step) {
            const EnergyTerms terms = energy().terms(now(), now().frames);
            const std::optional<Eigen::VectorXd> direction = newtonDirection();
            if (!direction) {
                status_ = MinimiseStatus::NotPositive;
                break;
            }
            IterationReport entry;
            entry.round = round;
            entry.terms = terms;
            entry.total = energy().total(terms, alpha_);
            entry.decrement = -0.5 * gradient_.dot(*direction);
            entry.step = takeStep(*direction, entry.total, -2.0 * entry.decrement);
            if (entry.decrement <= decrementShare * energy().scale(terms, alpha_)) {
                status_ = MinimiseStatus::Converged;
            } else if (entry.step == 0.0) {
                status_ = MinimiseStatus::LineSearchStalled;
            }
            report_.iterations.push_back(entry);
            ++report_.newtonIterations;
            ++steps_;
        }
        report_.seconds.minimise += watch_.lap();
    }

    [[nodiscard]] bool isAtRest() const { return status_ == MinimiseStatus::Converged; }

    [[nodiscard]] std::optional<Eigen::VectorXd> newtonDirection() {
        SplineSystem& system = stage_->system;
        for (const double share : kTurningShares) {
            energy().differentiate(now(), alpha_, share, gradient_, hessian_);
            double largest = 0.0;
            for (const SpanMatrix& block : hessian_) {
                largest = std::max(largest, block.diagonal().maxCoeff());
            }
            if (system.factorise(hessian_, kConstraintWeight * largest)) {
                return system.constrainedStep(
                    gradient_, system.residual(now().controls), kConstraintWeight * largest
                );
            }
        }
        return std::nullopt;
    }

    // Moves along a step as far as the energy falls enough; returns the share of it, 0 for none.
    double takeStep(const Eigen::VectorXd& step, double total, double slope) {
        double length = 1.0;
        for (int halving = 0; halving < kMaxHalvings; ++halving, length *= 0.5) {
            trial_ = now();
            Eigen::Map<Eigen::VectorXd>(trial_.controls.data(), trial_.controls.size()) +=
                length * step;
            energy().follow(finder_, trial_);
            const EnergyTerms terms = energy().terms(trial_, now().frames);
            if (energy().total(terms, alpha_) <= total + kSufficientDecrease * length * slope) {
                std::swap(now(), trial_);
                return length;
            }
        }
        return 0.0;
    }

    [[nodiscard]] std::vector<double> chooseBreaks() {
        KnotDemand gain;
        for (int span = 0; span < space().spanCount(); ++span) {
            gain.perSpan.push_back(energy().gainOfBulge(now(), alpha_, span));
            gain.total += gain.perSpan.back();
        }
        const double scale = energy().scale(energy().terms(now(), now().frames), alpha_);
        return gain.total < kNegligibleGain * scale
                   ? space().breaks()
                   : halveLargest(space(), gain, options_.minimumSpan);
    }

    // Traces the whole curve; where it leaves the tolerance, sets finer breaks.
    [[nodiscard]] bool isWithinTolerance(std::vector<double>& breaks) {
        const CurveDistance distance = measureDistance(problem_, space(), now().controls);
        report_.maxDistance = distance.largest / problem_.averageEdgeLength;
        if (distance.largest < tolerance_) {
            return true;
        }
        std::vector<char> marked(at(space().spanCount()), 0);
        for (int span = 0; span < space().spanCount(); ++span) {
            // Beyond the span on which the curve leaves the shell nothing is known.
            const bool isKnown = span == 0 || std::isfinite(distance.perSpan[at(span) - 1]);
            marked[at(span)] = distance.perSpan[at(span)] >= tolerance_ && isKnown ? 1 : 0;
        }
        breaks = halveSpans(space(), marked, options_.minimumSpan);
        return false;
    }

    void insert(std::vector<double> breaks) {
        if (breaks == space().breaks()) {
            return;
        }
        SplineSpace finer(options_.degree, options_.closed, std::move(breaks));
        ControlPoints controls = refine(space(), now().controls, finer);
        const std::unique_ptr<Stage> old = std::move(stage_);
        stage_ = makeStage(std::move(finer), std::move(controls));
        int near = 0;
        for (int sample = 0; sample < energy().sampleCount(); ++sample) {
            const double t = energy().parameter(sample);
            while (near + 1 < old->energy.sampleCount() &&
                   std::abs(old->energy.parameter(near + 1) - t) <
                       std::abs(old->energy.parameter(near) - t)) {
                ++near;
            }
            now().feet[at(sample)] = old->now.feet[at(near)];
        }
        energy().follow(finder_, now());
        report_.seconds.knots += watch_.lap();
    }

    void addRound(double ratio) {
        report_.rounds.push_back(
            {alpha_, 0.0, knotCount(), steps_, status_, ratio * options_.distanceTolerance}
        );
    }

    [[nodiscard]] Solution finish() {
        stage_->system.meetConstraints(now().controls);  // rounding of many steps
        report_.status = isAtRest() ? SolveStatus::Converged : SolveStatus::DistanceReached;
        report_.usable = true;
        report_.knotsLast = knotCount();
        report_.maxPickGap = stage_->system.residual(now().controls).lpNorm<Eigen::Infinity>();
        if (fieldWeight(problem_) > 0.0) {
            report_.fieldCost = energy().terms(now(), now().frames).external;
            report_.fieldAtRest = isAtRest();
        } else if (options_.fieldWeight > 0.0) {
            report_.fieldCost = problem_.fieldCosts.least;
        }
        report_.seconds.knots += watch_.lap();
        return {{stage_->space, std::move(now().controls)}, std::move(report_)};
    }

    const CurveProblem& problem_;
    const SolverOptions& options_;
    FootFinder finder_;
    Stopwatch watch_;
    double tolerance_;  // of the distance, in the shell's frame
    double heightUnit_;
    double alpha_;
    MinimiseStatus status_ = MinimiseStatus::IterationLimit;  // of the last descent
    int steps_ = 0;                                           // of the round
    std::unique_ptr<Stage> stage_;
    FootedSpline trial_;
    Eigen::VectorXd gradient_;
    std::vector<SpanMatrix> hessian_;
    SolveReport report_;
};

}  // namespace

std::optional<Solution> relax(
    const CurveProblem& problem, const GuidePath& guide, const SplineCurve& first
) {
    if (!isForFootPoints(problem)) {
        return std::nullopt;
    }
    std::optional<Solution> solution = Relaxer(problem, guide, first).run();
    if (solution && !isClear(problem, solution->curve)) {
        return std::nullopt;
    }
    return solution;
}

}  // namespace bspline_curve
