// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/cellwise_solver.h"

#include "projection/curve_distance.h"
#include "solver/cellwise_energy.h"
#include "solver/cellwise_newton.h"
#include "solver/knot_insertion.h"
#include "solver/shell_reach.h"
#include "solver/weights.h"
#include "utility/report_progress.h"
#include "utility/stopwatch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

namespace bspline_curve {
namespace {

// Newton stops at this share of the energy in rounds that only prepare the next one, while frozen
// directions still change, and at last.
struct Effort {
    double rough, rest, fine;
    int restIterations;  // altogether, at rest
};

// With 1e-3 in the rounds curves depend on the triangulation by up to 1.6 tolerances.
constexpr Effort kPlainEffort = {1e-4, 1e-4, 1e-6, std::numeric_limits<int>::max()};
// Under a field Newton crawls where a curve lies along edges at which the field's gradient jumps:
// the digits beyond these cost as many iterations as all before, and move nothing. Strong ones
// still creep then, by a per cent of the energy in a hundred iterations.
constexpr Effort kFieldEffort = {1e-2, 1e-4, 1e-4, 15};
// The same where a round's energy is sampled. 1e-3 takes a tenth more iterations.
constexpr double kSampledDecrement = 5e-3;
// More knots no longer change the curve where they would lower the energy by less than this share.
// 0.01 and 0.06 measured: the same bending within 2 %, a quarter more and a tenth fewer knots.
constexpr double kNegligibleGain = 0.03;
// The same at samples, which see less of it: 0.03 gave 1.5 % more bending, with 7 % fewer knots.
constexpr double kNegligibleSampledGain = 0.02;
// The curve is at rest where refreshing the frozen directions moves no control point farther than
// this share of the distance tolerance; it converges linearly, about one digit per refresh.
constexpr double kRestShare = 0.1;
constexpr int kMaxRefreshes = 6;
// Share of the fresh directions while knots are still inserted: alone they can alternate between
// two states.
constexpr double kRoughBlend = 0.5;

// ... or, where there is tension, move it by less than this share of the distance of two picks, and
// less than the tolerance: a corner at a pick gains by the same share however fine the knots.
constexpr double kMoveShare = 5e-3;

// Rounds that only prepare the next one need no exact integrals: in a simplified shell, where the
// walk from sample to sample seldom leaves the shell, E_dist is sampled at two points on each of so
// many parts of a span. Not where a field draws the samples into its valleys, and the curve between
// them over its ridges, nor where tension leaves little that holds the curve between samples.
constexpr int kRoughSegments = 2;  // even, so that halved spans have the same samples
constexpr double kHighestRoughTension = 0.5;
// Sampled energies have kinks, at which line searches stall: less than half a step is not worth it.
constexpr double kRoughLeastStep = 0.3;
constexpr double kLeastStep = 1e-10;
// A stall with more of the energy left to gain is no end: weights and knots would grow in vain.
constexpr double kStuckDecrement = 0.1;

// Weight of E_avoid. Over 169 curves on two scans 1, 3 and 10 take the same iterations; with 3
// curves keep about half the margin where they bend round an obstacle.
constexpr double kAvoidance = 3.0;

// A field whose pull is less than the digits that are asked of E_int, at 5 and more, is none.
constexpr double kFaintField = 1e-6;

bool hasPull(const CurveProblem& problem) {
    return fieldStrength(problem) > kFaintField;
}

// E_ext; what costs the same everywhere is not integrated.
double meanFieldCost(const CurveProblem& problem, const EnergyTerms& terms) {
    if (problem.options.fieldWeight == 0.0) {
        return 0.0;
    }
    return fieldWeight(problem) > 0.0 ? terms.external : problem.fieldCosts.least;
}

int firstSegments(const CurveProblem& problem) {
    if (problem.options.quadrature == Quadrature::Samples) {
        return (problem.options.samplesPerSpan + 1) / 2;  // two samples each
    }
    const bool isSmooth = problem.options.tension <= kHighestRoughTension && !hasPull(problem);
    // Straight walks between samples cut the corners of what the curve avoids.
    const bool isFree = problem.obstacles == nullptr;
    return problem.shell->isFullResolution() || !isSmooth || !isFree ? 0 : kRoughSegments;
}

// E_int of the geodesics between the picks: the tension term of no curve on the surface is less.
// Corners that are cut at lambda = 1 are a few per cent of it, and would not be seen beside it.
// Parameters follow the length of the initial path.
double tensionFloor(const CurveProblem& problem, const InitialPath& initialPath) {
    double length = 0.0;
    for (std::size_t i = 1; i < initialPath.points.size(); ++i) {
        length += (initialPath.points[i].position - initialPath.points[i - 1].position).norm();
    }
    const double ratio = length / problem.chordLength;
    return problem.options.tension * ratio * ratio;
}

double shortestPickDistance(const CurveProblem& problem) {
    double shortest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < problem.picks.size(); ++i) {
        shortest =
            std::min(shortest, (problem.picks[i].position - problem.picks[i - 1].position).norm());
    }
    return shortest;
}

// Whether a line search ended far from the minimum.
bool isStuck(const MinimiseResult& result) {
    return result.status == MinimiseStatus::LineSearchStalled &&
           result.iterations.back().decrement > kStuckDecrement * result.value.scale;
}

// What belongs to one knot vector.
struct Stage {
    Stage(const CurveProblem& problem, const SplineSpace& space, int segments)
        : rows(interpolationRows(space, problem.picks)),
          energy(problem, space, rows, segments),
          system(space, rows) {}

    std::vector<InterpolationRow> rows;
    CellwiseEnergy energy;
    SplineSystem system;
};

class Solver {
public:
    Solver(const CurveProblem& problem, const InitialPath& initialPath, SplineCurve first)
        : problem_(problem),
          options_(problem.options),
          curve_(std::move(first)),
          segments_(firstSegments(problem)),
          effort_(hasPull(problem) ? kFieldEffort : kPlainEffort),
          decrement_(effort_.rough),
          stage_(std::make_unique<Stage>(problem, curve_.space, segments_)),
          tolerance_(problem.distanceTolerance),
          restingMove_(std::min(tolerance_, kMoveShare * shortestPickDistance(problem))),
          tensionFloor_(tensionFloor(problem, initialPath)) {
        report_.knotsFirst = knotCount();
    }

    // Alg. 1: minimise, then raise the weights and insert knots, until neither changes the curve;
    // then come to rest.
    Solution run() {
        weights_ = firstWeights(options_, measure());
        // E_dist goes with the square of the relative height, so a thick shell is softer.
        // A strong field must not press the first curve against top and bottom.
        const double reach = relativeReach(problem_);
        weights_.alpha *= reach * reach * (1.0 + fieldStrength(problem_));
        weights_.avoidance = kAvoidance;
        for (round_ = 0; round_ < options_.maxRounds; ++round_) {
            bspline_curve::report(problem_.progress, progressFraction(), "minimising");
            refreshDirections(kRoughBlend);
            const ControlPoints before = curve_.controls;
            MinimiseResult result = minimiseOnce(isRough() ? kSampledDecrement : decrement_);
            double largestHeight = measure();
            if (isRough() && (!std::isfinite(distance_) || isStuck(result))) {
                // It left the shell between two samples, or a kink of the sampled energy holds it.
                if (!std::isfinite(distance_)) {
                    curve_.controls = before;
                }
                becomeExact();
                refreshDirections(kRoughBlend);
                result = minimiseOnce(decrement_);
                largestHeight = measure();
            }
            if (!isNear() && result.iterations.size() <= 1) {
                // It stopped where it started: from now on further, else alpha grows in vain.
                decrement_ = std::min(decrement_, effort_.rest);
            }
            addRound(result);
            std::vector<double> breaks = chooseBreaks(result.value.scale);
            const bool noKnots = breaks == curve_.space.breaks();
            if (noKnots && isRough()) {
                becomeExact();  // what is left lies between the samples
            }
            if (isNear() && noKnots) {
                rest();
                if (isNear()) {
                    break;
                }
            }
            const EnergyWeights next = nextWeights(
                options_,
                weights_,
                result.value.terms,
                fieldWeight(problem_),
                largestHeight,
                alphaStep(distance_ / tolerance_, !problem_.shell->isFullResolution())
            );
            if (noKnots && next.alpha <= weights_.alpha && !isNear()) {
                report_.status = SolveStatus::KnotLimit;
                break;
            }
            weights_ = next;
            insert(std::move(breaks));
        }
        finish();
        return {std::move(curve_), std::move(report_), {}};
    }

private:
    [[nodiscard]] bool isNear() const { return distance_ < tolerance_; }

    [[nodiscard]] bool isRough() const {
        return options_.quadrature != Quadrature::Samples && segments_ > 0;
    }

    // Integrates cell by cell from now on.
    void becomeExact() {
        segments_ = 0;
        stage_->energy.setSegments(0);
    }

    [[nodiscard]] int knotCount() const {
        return static_cast<int>(curve_.space.knotVector().size());
    }

    // Distance falls geometrically, so progress is its logarithm; rounds bound it from below.
    [[nodiscard]] double progressFraction() const { return 0.9 * (1.0 - std::pow(0.75, round_)); }

    MinimiseResult minimiseOnce(
        double decrement, int mostIterations = std::numeric_limits<int>::max()
    ) {
        MinimiseResult result;
        result = minimise(
            stage_->energy,
            stage_->system,
            weights_,
            options_.interpolation,
            {std::min(options_.maxIterations, mostIterations),
             decrement,
             isRough() ? kRoughLeastStep : kLeastStep},
            curve_.controls
        );
        for (IterationReport entry : result.iterations) {
            entry.round = round_;
            report_.iterations.push_back(entry);
        }
        if (options_.interpolation == Interpolation::Constraint) {
            stage_->system.meetConstraints(curve_.controls);  // rounding of many steps
        }
        report_.fieldCost = meanFieldCost(problem_, result.value.terms);
        report_.fieldAtRest = !hasPull(problem_) || result.status == MinimiseStatus::Converged;
        report_.newtonIterations += static_cast<int>(result.iterations.size());
        report_.seconds.minimise += watch_.lap();
        return result;
    }

    // The directions along the current curve, blended with those before.
    void refreshDirections(double blend) {
        if (options_.bending == Bending::Ambient) {
            return;
        }
        std::optional<BendingDirections> fresh =
            bendingDirectionsAlong(problem_, curve_.space, curve_.controls, segments_);
        if (!fresh && isRough()) {
            becomeExact();
            fresh = bendingDirectionsAlong(problem_, curve_.space, curve_.controls, segments_);
        }
        if (!fresh) {
            return;
        }
        if (!directions_.samples.empty() && blend < 1.0) {
            for (BendingDirections::Sample& sample : fresh->samples) {
                sample.direction =
                    (blend * sample.direction + (1.0 - blend) * directions_.at(sample.parameter))
                        .normalized();
            }
        }
        directions_ = std::move(*fresh);
        stage_->energy.setDirections(directions_);
    }

    // Updates the distance to the surface; returns the largest relative height.
    double measure() {
        const CurveDistance distance =
            measureDistance(traceStartOf(problem_), curve_.space, curve_.controls);
        distance_ = distance.largest;
        return distance.largestHeight;
    }

    void addRound(const MinimiseResult& result) {
        report_.rounds.push_back(
            {weights_.alpha,
             weights_.beta,
             knotCount(),
             static_cast<int>(result.iterations.size()),
             result.status,
             distance_ / problem_.averageEdgeLength}
        );
    }

    [[nodiscard]] std::vector<double> chooseBreaks(double energy) {
        if (options_.knotRule == KnotRule::EnergyAndDistance) {
            const KnotDemand gain = predictGain(
                problem_,
                curve_.space,
                curve_.controls,
                weights_,
                directions_,
                isRough() ? kRoughSegments / 2 : segments_
            );
            const double negligible = isRough() ? kNegligibleSampledGain : kNegligibleGain;
            const bool settled = gain.total < negligible * (energy - tensionFloor_) ||
                                 (tensionFloor_ > 0.0 && gain.largestMove < restingMove_);
            return settled ? curve_.space.breaks()
                           : halveLargest(curve_.space, gain, options_.minimumSpan);
        }
        const KnotDemand feature =
            featureFunction(problem_, curve_.space, curve_.controls, weights_);
        const double before = std::exchange(feature_, feature.total);
        // The paper's rules 1 and 2; rule 3 is that insertByFeature finds no room.
        const double threshold = kNegligibleGain * energy;
        const bool small =
            std::all_of(feature.perSpan.begin(), feature.perSpan.end(), [&](double value) {
                return value < threshold;
            });
        if (isNear() && (small || std::abs(feature.total - before) < threshold)) {
            return curve_.space.breaks();
        }
        return insertByFeature(curve_.space, feature, options_.minimumSpan);
    }

    void insert(std::vector<double> breaks) {
        if (breaks != curve_.space.breaks()) {
            SplineSpace finer(options_.degree, options_.closed, std::move(breaks));
            ControlPoints controls = refine(curve_.space, curve_.controls, finer);
            curve_.space = std::move(finer);
            curve_.controls = std::move(controls);
            stage_ = std::make_unique<Stage>(problem_, curve_.space, segments_);
        }
        report_.seconds.knots += watch_.lap();
    }

    // Minimises to the end, with the frozen directions refreshed until they no longer move the
    // curve.
    void rest() {
        report_.status = SolveStatus::DistanceReached;
        double movedBefore = std::numeric_limits<double>::infinity();
        double blend = 1.0;
        int iterationsLeft = effort_.restIterations;
        const auto isMinimal = [&](double decrement) {
            const MinimiseResult result = minimiseOnce(decrement, iterationsLeft);
            iterationsLeft -= static_cast<int>(result.iterations.size());
            return result.status == MinimiseStatus::Converged;
        };
        for (int refresh = 0; refresh < kMaxRefreshes; ++refresh) {
            const ControlPoints before = curve_.controls;
            refreshDirections(blend);
            if (!isMinimal(effort_.rest)) {
                break;
            }
            const double moved = (curve_.controls - before).rowwise().norm().maxCoeff();
            if (moved > movedBefore) {
                blend = kRoughBlend;
            }
            movedBefore = moved;
            if (moved < kRestShare * tolerance_) {
                if (isMinimal(effort_.fine)) {
                    report_.status = SolveStatus::Converged;
                }
                break;
            }
        }
        measure();
    }

    // A penalty leaves gaps at the picks: one constrained step closes them.
    void meetPicks() {
        EnergyDerivatives derivatives;
        if (!stage_->energy.evaluate(curve_.controls, weights_, derivatives).inside) {
            return;
        }
        const std::optional<NewtonStep> step =
            newtonStep(stage_->system, derivatives, Interpolation::Constraint, curve_.controls);
        if (step) {
            Eigen::Map<Eigen::VectorXd>(curve_.controls.data(), curve_.controls.size()) +=
                step->direction;
            measure();
        }
    }

    void finish() {
        report_.knotsLast = knotCount();
        if (options_.interpolation == Interpolation::Penalty) {
            meetPicks();
        }
        report_.maxPickGap = stage_->system.residual(curve_.controls).lpNorm<Eigen::Infinity>();
        report_.maxDistance = distance_ / problem_.averageEdgeLength;
        report_.usable = isNear();
        report_.seconds.minimise += watch_.lap();
    }

    const CurveProblem& problem_;
    const SolverOptions& options_;
    Stopwatch watch_;
    SplineCurve curve_;
    int segments_;  // on each span, of two samples each; 0: integrals cell by cell
    Effort effort_;
    double decrement_;  // at which exact rounds stop
    std::unique_ptr<Stage> stage_;
    EnergyWeights weights_;
    BendingDirections directions_;
    SolveReport report_;
    double tolerance_;
    double restingMove_;     // more knots change nothing where they move the curve less than this
    double tensionFloor_;    // what no knot can save of E_int
    double distance_ = 0.0;  // of curve and surface, in the shell's frame
    double feature_ = 0.0;   // (19) of the round before
    int round_ = 0;
};

}  // namespace

Solution solveInShell(
    const CurveProblem& problem, const InitialPath& initialPath, SplineCurve first
) {
    return Solver(problem, initialPath, std::move(first)).run();
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
