// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/sampled_solver.h"

#include "projection/fibre_tracer.h"
#include "solver/cell_integrand.h"
#include "solver/knot_insertion.h"
#include "solver/obstacles.h"
#include "solver/sampled_newton.h"
#include "utility/report_progress.h"
#include "utility/stopwatch.h"
#include "utility/worker_thread.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <utility>

namespace bspline_curve {
namespace {

// The first curve is a fit to the initial path within this share of the length of the polygon of
// picks. 0.01 takes 40 % more steps, 0.002 makes curves stick to where they start.
constexpr double kFirstDistance = 0.0031;
// And under a strong field, which has bent the initial path: with less curves take longer, with
// twice as much they stay in worse valleys.
constexpr double kFirstFieldDistance = 0.005;
// A tight fit within so many tolerances. With one, or with five, fewer of the curves that need it
// come to lie in the shell.
constexpr double kTightDistance = 2.0;

// Heights are measured in this many tolerances: in mean edge lengths with the default tolerance.
constexpr double kUnitInTolerances = 10.0;
// First weight of the distance, per squared length of the polygon of picks. Over 24 curves on 8
// scans a third of it takes a seventh more steps for the same bending; with 2.7 times as much
// curves stick to where they start, for 8 % more bending, and one for twice as much.
constexpr double kFirstStiffness = 1.35e6;
constexpr double kLeastFirstAlpha = 5.0;
// Under a field this times 1 + so many times its strength, where that is more. Over 72 random
// curves on 3 scans 1, 2.5 and 4 times lead to the same costs within 1 % and bending within 5 %,
// with fewer steps the larger it is (15.9, 15.4, 14.5 on the coarsest meshes); with 4 one of 24
// other curves follows its field less.
constexpr double kFirstFieldStiffness = 4.5e5;
constexpr double kStiffnessByStrength = 2.5;
// A curve that starts from another one starts with this share of its last weight. With all of it
// it sticks to where the other one was, and takes knots for that; with a hundredth it takes a tenth
// longer and bends as much.
constexpr double kRestartShare = 0.2;
// It grows by what is needed to come below the tolerance, as heights fall with a power of it.
// Growth by 4 and 6 at most takes more steps over 24 curves on 8 scans, for more bending.
constexpr double kAlphaFactor = 10.0;
constexpr double kLeastAlphaFactor = 1.5;
constexpr double kDistanceExponent = 1.5;
// After a start from another curve by at least this, until it is what it was there.
constexpr double kReturnFactor = 3.0;
constexpr double kHighestAlpha = 1e9;
// Short stopPolicy ends where so many rounds have not brought the farthest sample, this many
// tolerances away, nearer than to this share. Of 480 random curves on 8 scans 65 of the 91 end so
// that would end in vain later, and five others, which bend by an eighth less for it.
constexpr double kFarRatio = 3.0;
constexpr int kStuckRounds = 2;
constexpr double kStuckShare = 0.8;
// Not before its weight of the distance has become so many times as large: on fine meshes a usual
// curve may stay far away while it is a few hundred times as large.
constexpr double kStuckGrowth = 9e3;

// Newton stops after so many steps, while weights and knots still change, and at last.
constexpr int kMaxSteps = 30;
constexpr int kMaxRestSteps = 10;
// At last also where a step has brought less than this share of what it promised: samples wander
// between kinks of the surface.
constexpr double kKeptPromise = 0.5;
// Where all samples are near enough, but knots then become so many times as many, some of them on
// spans shorter than the tolerance, short stopPolicy ends. Usual curves come to rest with up to
// twice as many.
constexpr double kMostGrowth = 2.25;
// Under a field a round ends where so many steps gain less than one of them should.
constexpr int kLastSteps = 3;

struct Descent {
    double decrement;
    int mostSteps;
    bool isLast;
};

constexpr Descent kRoundDescent{kRoundDecrement, kMaxSteps, false};
constexpr Descent kLastDescent{kRestDecrement, kMaxRestSteps, true};

// More knots no longer change the curve where bulges of all spans would lower the energy by less
// than this share. 0.02 gives 3 % more bending with a tenth fewer knots.
constexpr double kNegligibleGain = 0.01;
// So many spans at once are asked by one of two threads.
constexpr int kSpansAtOnce = 16;
// A curve whose energy is less than this is a segment, but for roundings.
constexpr double kStraightEnergy = 1e-12;

// Bulges do not say what quadratic splines gain by knots.
constexpr int kLeastDegree = 3;
// With more tension little holds a curve between samples, and corners at picks want knots that
// bulges do not ask for.
constexpr double kHighestTension = 0.5;
// Stronger fields draw the samples into valleys that are narrower than the way between two samples.
constexpr double kStrongestField = 20.0;

// Whether what the curve avoids is too far away to push it anywhere.
bool isClear(const CurveProblem& problem, const Solution& solution) {
    const Obstacles* const obstacles = problem.obstacles;
    return obstacles == nullptr || std::ranges::all_of(facesPassed(solution), [&](int face) {
               return obstacles->isFar(face);
           });
}

// A weight of the distance that holds a curve as fast on every resolution.
double alphaOf(const CurveProblem& problem, double stiffness) {
    const double share = heightUnitOf(problem) / problem.chordLength;
    return stiffness * share * share;
}

class SampledSolver {
public:
    SampledSolver(
        const CurveProblem& problem,
        const InitialPath& initialPath,
        std::optional<SampledStart> start,
        StopPolicy stopPolicy
    )
        : problem_(problem),
          options_(problem.options),
          stopPolicy_(stopPolicy),
          finder_(*problem.extended, problem.patches),
          tolerance_(problem.distanceTolerance),
          heightUnit_(heightUnitOf(problem)),
          segments_(segmentsOf(start, stopPolicy)),
          startAlpha_(start ? start->alpha : 0.0),
          alpha_(std::max(firstAlphaOf(problem), kRestartShare * startAlpha_)),
          newton_(newtonFrom(start ? std::move(start->curve) : looseFit(problem, initialPath))) {
        startOnPath(initialPath);
        report_.knotsFirst = knotCount();
        report_.seconds.initial = watch_.lap();
    }

    std::optional<Solution> run() {
        for (int round = 0; round < options_.maxRounds; ++round) {
            bspline_curve::report(problem_.progress, progressFraction(round), "minimising");
            steps_ = 0;
            descend(round, kRoundDescent);
            const double ratio = energy().largestHeight(now()) / tolerance_;
            std::vector<double> breaks = chooseBreaks();
            const bool isSettled = breaks == space().breaks();
            addRound(ratio);
            if (isSettled && ratio < kAimedShare) {
                descend(round, kLastDescent);
                if (isWithinTolerance(breaks)) {
                    return finish();
                }
                if (breaks == space().breaks()) {
                    return std::nullopt;  // no span can be halved any more
                }
            } else if (ratio >= kAimedShare) {
                if (alpha_ > kHighestAlpha || isStuck(ratio)) {
                    return std::nullopt;
                }
                alpha_ *= alphaFactor(ratio);
                knotsNearby_ = 0;
            } else if (multipliesKnots()) {
                return std::nullopt;
            }
            insert(std::move(breaks));
        }
        return std::nullopt;
    }

private:
    // After a first attempt has failed, most.
    [[nodiscard]] static int segmentsOf(
        const std::optional<SampledStart>& start, StopPolicy stopPolicy
    ) {
        const bool isAgain = stopPolicy == StopPolicy::Long || (start && start->isTight);
        return isAgain ? SampledEnergy::kMostSegments : SampledEnergy::kUsualSegments;
    }

    // By what the samples need to come below the tolerance, or to be back at the weight of the
    // curve that this one started from.
    [[nodiscard]] double alphaFactor(double ratio) const {
        return std::max(alphaGrowth(ratio), std::min(kReturnFactor, startAlpha_ / alpha_));
    }

    [[nodiscard]] FootedSpline& now() { return newton_->now(); }

    [[nodiscard]] const SampledEnergy& energy() const { return newton_->energy(); }

    [[nodiscard]] const SplineSpace& space() const { return newton_->space(); }

    [[nodiscard]] int knotCount() const { return static_cast<int>(space().knotVector().size()); }

    [[nodiscard]] static double progressFraction(int round) { return 1.0 - std::pow(0.75, round); }

    [[nodiscard]] std::unique_ptr<SampledNewton> newtonFrom(SplineCurve curve) const {
        return std::make_unique<SampledNewton>(problem_, std::move(curve), heightUnit_, segments_);
    }

    void startOnPath(const InitialPath& initialPath) {
        std::size_t near = 0;
        for (int sample = 0; sample < energy().sampleCount(); ++sample) {
            const double t = energy().parameter(sample);
            while (near + 1 < initialPath.points.size() &&
                   initialPath.points[near + 1].parameter <= t) {
                ++near;
            }
            const SurfacePoint& point = initialPath.points[near].point;
            now().feet[sample] = {point.face, point.barycentric[1], point.barycentric[2], 0.0};
        }
        newton_->follow(finder_);
    }

    // Newton's method until a step promises less than its share of the energy.
    void descend(int round, const Descent& descent) {
        status_ = MinimiseStatus::IterationLimit;
        std::vector<double> totals;
        double promisedBefore = 0.0;
        const int most = std::min(descent.mostSteps, options_.maxIterations);
        for (int step = 0; step < most && status_ == MinimiseStatus::IterationLimit; ++step) {
            const std::optional<SampledNewton::Step> taken = newton_->step(finder_, alpha_);
            if (!taken) {
                status_ = MinimiseStatus::NotPositive;
                break;
            }
            totals.push_back(taken->total);
            const double least = descent.decrement * taken->scale;
            if (promised(*taken) <= least) {
                status_ = MinimiseStatus::Converged;
            } else if (taken->length == 0.0 ||
                       (descent.isLast && fallOfStep(totals) < kKeptPromise * promisedBefore) ||
                       (!descent.isLast && hasField() && fallOfLast(totals) < least)) {
                status_ = MinimiseStatus::LineSearchStalled;
            }
            promisedBefore = promised(*taken);
            IterationReport entry;
            entry.round = round;
            entry.terms = taken->terms;
            entry.total = taken->total;
            entry.decrement = taken->decrement;
            entry.step = taken->length;
            report_.iterations.push_back(entry);
            ++report_.newtonIterations;
            ++steps_;
        }
        report_.seconds.minimise += watch_.lap();
    }

    // What a step gains by its promise: a short one not all of that. Only kinks of a field make
    // steps short again and again.
    [[nodiscard]] double promised(const SampledNewton::Step& step) const {
        const bool isShort = hasField() && step.length > 0.0;
        return step.decrement * (isShort ? step.length * (2.0 - step.length) : 1.0);
    }

    // By how much the step before has brought the energy down; infinite at first.
    [[nodiscard]] static double fallOfStep(const std::vector<double>& totals) {
        return totals.size() < 2 ? std::numeric_limits<double>::infinity()
                                 : totals.end()[-2] - totals.back();
    }

    // By how much the last steps have brought the energy below all before; infinite after few.
    [[nodiscard]] static double fallOfLast(const std::vector<double>& totals) {
        if (totals.size() <= kLastSteps) {
            return std::numeric_limits<double>::infinity();
        }
        const auto last = totals.end() - kLastSteps;
        return *std::min_element(totals.begin(), last) - *std::min_element(last, totals.end());
    }

    // Whether the curve has stayed far from the surface while the weight of the distance has grown
    // a hundred times, and much before: on the wrong side of a thin part, it does not find back.
    [[nodiscard]] bool isStuck(double ratio) const {
        const std::vector<RoundReport>& rounds = report_.rounds;
        return stopPolicy_ == StopPolicy::Short && ratio > kFarRatio &&
               rounds.size() > kStuckRounds && alpha_ > kStuckGrowth * rounds.front().alpha &&
               rounds.back().maxDistance >
                   kStuckShare * (rounds.end() - 1 - kStuckRounds)->maxDistance;
    }

    // Whether knots multiply on a curve whose samples are all near enough, where there is nothing
    // to follow: on spans shorter than the tolerance.
    [[nodiscard]] bool multipliesKnots() {
        knotsNearby_ = knotsNearby_ > 0 ? knotsNearby_ : knotCount();
        return stopPolicy_ == StopPolicy::Short && knotCount() > kMostGrowth * knotsNearby_ &&
               shortestSpan() < tolerance_;
    }

    [[nodiscard]] double shortestSpan() {
        double shortest = std::numeric_limits<double>::infinity();
        for (int span = 0; span < space().spanCount(); ++span) {
            const PolynomialCurve curve = space().polynomial(now().controls, span);
            shortest = std::min(shortest, (curve.at(1.0) - curve.at(0.0)).norm());
        }
        return shortest;
    }

    [[nodiscard]] bool hasField() const { return fieldWeight(problem_) > 0.0; }

    [[nodiscard]] bool isAtRest() const { return status_ == MinimiseStatus::Converged; }

    [[nodiscard]] std::vector<double> chooseBreaks() {
        KnotDemand gain;
        gain.perSpan.resize(space().spanCount());
        forEach(problem_.side, space().spanCount(), kSpansAtOnce, [&](int span) {
            gain.perSpan[span] = energy().refinementGain(now(), alpha_, span);
        });
        gain.total = std::accumulate(gain.perSpan.begin(), gain.perSpan.end(), 0.0);
        const double scale = energy().scale(energy().terms(now(), now().frames), alpha_);
        return gain.total < kNegligibleGain * std::max(scale, kStraightEnergy)
                   ? space().breaks()
                   : halveLargest(space(), gain, options_.minimumSpan);
    }

    // Traces the whole curve; where it leaves the tolerance, sets finer breaks.
    [[nodiscard]] bool isWithinTolerance(std::vector<double>& breaks) {
        newton_->system().meetConstraints(now().controls);  // rounding of many steps
        CurveDistance distance = measure();
        report_.maxDistance = distance.largest / problem_.averageEdgeLength;
        if (distance.largest < tolerance_) {
            trace_ = std::move(distance.trace);
            return true;
        }
        std::vector<char> marked(space().spanCount(), 0);
        for (int span = 0; span < space().spanCount(); ++span) {
            // Beyond the span on which the curve leaves the shell nothing is known.
            const bool isKnown = span == 0 || std::isfinite(distance.perSpan[span - 1]);
            marked[span] = distance.perSpan[span] >= tolerance_ && isKnown ? 1 : 0;
        }
        breaks = halveSpans(space(), marked, options_.minimumSpan);
        return false;
    }

    [[nodiscard]] CurveDistance measure() {
        return problem_.shell != nullptr
                   ? measureDistance(traceStartOf(problem_), space(), now().controls)
                   : measureAlongFibres(problem_, space(), now().controls, footAtMiddle());
    }

    // The start of the middle span, from its first sample.
    [[nodiscard]] FootOfSpan footAtMiddle() {
        const int span = space().spanCount() / 2;
        const std::size_t sample = (span * energy().samplesPerSpan());
        FootPoint foot = now().feet[sample];
        FootFrame frame = now().frames[sample];
        const Vec3 start = space().polynomial(now().controls, span).coefficients[0];
        FibreProjector::predict(start - now().positions[sample], frame, foot);
        finder_.move(start, foot, frame);
        return {span, foot};
    }

    void insert(std::vector<double> breaks) {
        if (breaks == space().breaks()) {
            return;
        }
        SplineSpace finer(options_.degree, options_.closed, std::move(breaks));
        ControlPoints controls = refine(space(), now().controls, finer);
        const std::unique_ptr<SampledNewton> old = std::move(newton_);
        newton_ = newtonFrom({std::move(finer), std::move(controls)});
        newton_->followRefined(finder_, *old);
        report_.seconds.knots += watch_.lap();
    }

    void addRound(double ratio) {
        report_.rounds.push_back(
            {alpha_,
             0.0,
             knotCount(),
             steps_,
             status_,
             ratio * tolerance_ / problem_.averageEdgeLength}
        );
    }

    [[nodiscard]] Solution finish() {
        report_.status = isAtRest() ? SolveStatus::Converged : SolveStatus::DistanceReached;
        report_.usable = true;
        report_.isSampled = true;
        report_.knotsLast = knotCount();
        report_.maxPickGap = newton_->system().residual(now().controls).lpNorm<Eigen::Infinity>();
        if (fieldWeight(problem_) > 0.0) {
            report_.fieldCost = energy().terms(now(), now().frames).external;
            report_.fieldAtRest = isAtRest();
        } else if (options_.fieldWeight > 0.0) {
            report_.fieldCost = problem_.fieldCosts.least;
        }
        report_.seconds.knots += watch_.lap();
        return {{space(), std::move(now().controls)}, std::move(report_), std::move(trace_)};
    }

    const CurveProblem& problem_;
    const SolverOptions& options_;
    StopPolicy stopPolicy_;
    FibreProjector finder_;
    Stopwatch watch_;
    double tolerance_;  // of the distance, in the shell's frame
    double heightUnit_;
    int segments_;       // of SampledEnergy
    double startAlpha_;  // of the curve that this one starts from, or 0
    double alpha_;
    MinimiseStatus status_ = MinimiseStatus::IterationLimit;  // of the last descent
    int steps_ = 0;                                           // of the round
    int knotsNearby_ = 0;  // since when all samples have been near enough, or 0
    std::unique_ptr<SampledNewton> newton_;
    std::optional<CurveTrace> trace_;  // at the end
    SolveReport report_;
};

}  // namespace

bool isForSamples(const CurveProblem& problem) {
    const SolverOptions& options = problem.options;
    return options.quadrature == Quadrature::FootPoints && options.degree >= kLeastDegree &&
           options.initialCurve == InitialCurve::GeodesicFit &&
           options.barrierWidth == BarrierWidth::Full &&
           options.distanceWeight == DistanceWeight::Schedule &&
           options.interpolation == Interpolation::Constraint &&
           options.knotRule == KnotRule::EnergyAndDistance && options.tension <= kHighestTension &&
           fieldStrength(problem) <= kStrongestField;
}

double heightUnitOf(const CurveProblem& problem) {
    return kUnitInTolerances * problem.distanceTolerance;
}

// A field lifts curves as well.
double firstAlphaOf(const CurveProblem& problem) {
    const double byField = 1.0 + kStiffnessByStrength * fieldStrength(problem);
    return std::max(
        kLeastFirstAlpha * byField,
        alphaOf(problem, std::max(kFirstStiffness, kFirstFieldStiffness * byField))
    );
}

double alphaGrowth(double ratio) {
    return std::clamp(
        std::pow(1.1 * ratio / kAimedShare, kDistanceExponent), kLeastAlphaFactor, kAlphaFactor
    );
}

SplineCurve looseFit(const CurveProblem& problem, const InitialPath& initialPath) {
    const double share = std::min(1.0, fieldStrength(problem));
    return fitLoosely(
        problem,
        initialPath,
        problem.chordLength * std::lerp(kFirstDistance, kFirstFieldDistance, share)
    );
}

SampledStart stiffStart(
    const CurveProblem& problem, const InitialPath& initialPath, double stiffness
) {
    return {
        fitLoosely(problem, initialPath, kTightDistance * problem.distanceTolerance),
        alphaOf(problem, stiffness),
        true
    };
}

std::optional<Solution> solveSampled(
    const CurveProblem& problem,
    const InitialPath& initialPath,
    std::optional<SampledStart> start,
    StopPolicy stopPolicy
) {
    if (!isForSamples(problem)) {
        return std::nullopt;
    }
    std::optional<Solution> solution =
        SampledSolver(problem, initialPath, std::move(start), stopPolicy).run();
    if (solution && !isClear(problem, *solution)) {
        return std::nullopt;
    }
    return solution;
}

}  // namespace bspline_curve
