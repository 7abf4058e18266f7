// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/cellwise_energy.h"

#include "projection/curve_distance.h"
#include "solver/knot_insertion.h"
#include "solver/problem_traces.h"
#include "solver/sampled_solver.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace bspline_curve {
namespace {

struct CellwiseEnergyConstants {
    /// Rounds that only prepare the next one take E_dist at two samples on each of so many parts of
    /// a span. Even, so that halved spans have the same samples.
    int roughSegments = 2;
    /// More knots no longer change the curve where they would lower the energy by less than this
    /// share of it; and at samples, which see less of it.
    double negligibleGain = 0.03;
    double negligibleSampledGain = 0.02;
    /// Or, under tension, where they move it by less than this share of the distance of two picks,
    /// and less than the tolerance: a corner at a pick gains by the same share however fine they
    /// are.
    double moveShare = 5e-3;
};

constexpr CellwiseEnergyConstants kCellwiseEnergy;

struct CellwiseNewtonConstants {
    /// Shares of the negative part. Damping it only on the spans that make the Hessian indefinite
    /// takes more iterations.
    std::array<double, 5> negativeShares = {1.0, 0.5, 0.25, 0.125, 0.0};
    /// Without that part the Hessian may still be indefinite: between faces to avoid, in ways that
    /// are one face wide, the closeness bends downwards.
    std::array<double, 3> ridges = {1e-2, 1.0, 1e2};
    /// In whole steps: more than any curve asked for.
    double longestStep = 64.0;
};

constexpr CellwiseNewtonConstants kCellwiseNewton;

SampleRule firstRule(const CurveProblem& problem) {
    if (problem.options.quadrature == Quadrature::Samples) {
        return segmentsOfCurve(problem.options.paper);
    }
    // A field draws the samples into its valleys, and the curve between them over its ridges.
    const bool isSmooth = problem.options.tension <= kSampled.highestTension && !hasPull(problem);
    // Straight walks between samples cut the corners of what the curve avoids.
    const bool isFree = problem.obstacles == nullptr;
    return problem.shell->isFullResolution() || !isSmooth || !isFree
               ? SampleRule{}
               : segmentsOfSpans(kCellwiseEnergy.roughSegments);
}

double shortestPickDistance(const CurveProblem& problem) {
    double shortest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < problem.picks.size(); ++i) {
        shortest =
            std::min(shortest, (problem.picks[i].position - problem.picks[i - 1].position).norm());
    }
    return shortest;
}

}  // namespace

NewtonPolicy cellwiseNewton() {
    NewtonPolicy policy;
    policy.negativeShares = kCellwiseNewton.negativeShares;
    policy.ridges = kCellwiseNewton.ridges;
    policy.longestStep = kCellwiseNewton.longestStep;
    return policy;
}

CellwiseEnergy::CellwiseEnergy(const CurveProblem& problem, SplineCurve curve, double tensionFloor)
    : Energy(problem, std::move(curve.space)),
      rule_(firstRule(problem)),
      tensionFloor_(tensionFloor),
      restingMove_(
          std::min(
              problem.distanceTolerance, kCellwiseEnergy.moveShare * shortestPickDistance(problem)
          )
      ),
      integrals_(std::make_unique<CellwiseIntegrals>(problem, space(), picks().rows(), rule_)),
      controls_(std::move(curve.controls)) {}

void CellwiseEnergy::setWeights(const EnergyWeights& weights) {
    Energy::setWeights(weights);
    isDifferentiated_ = false;
}

EnergyValue CellwiseEnergy::differentiate() {
    if (!isDifferentiated_) {
        value_ = integrals_->evaluate(controls_, weights_, derivatives_);
        spansSeen_ += space().spanCount();
        isDifferentiated_ = true;
    }
    hessian_ = derivatives_.hessian;
    negativeShare_ = 0.0;
    return value_;
}

const std::vector<SpanBlocks>& CellwiseEnergy::hessian(double negativeShare) {
    const double more = negativeShare - negativeShare_;
    for (std::size_t span = 0; more != 0.0 && span < hessian_.size(); ++span) {
        for (std::size_t block = 0; block < hessian_[span].size(); ++block) {
            hessian_[span][block] += more * derivatives_.negativeKinks[span][block];
        }
    }
    negativeShare_ = negativeShare;
    return hessian_;
}

// Mostly the whole step is taken, so its derivatives are computed with its value.
EnergyValue CellwiseEnergy::tryStep(const Eigen::VectorXd& step, double length) {
    trial_.resize(controls_.rows(), 3);
    Eigen::Map<Eigen::VectorXd>(trial_.data(), trial_.size()) =
        Eigen::Map<const Eigen::VectorXd>(controls_.data(), controls_.size()) + length * step;
    isTrialDifferentiated_ = length >= 1.0;
    trialValue_ = isTrialDifferentiated_ ? integrals_->evaluate(trial_, weights_, trialDerivatives_)
                                         : integrals_->evaluate(trial_, weights_);
    spansSeen_ += space().spanCount();
    return trialValue_;
}

void CellwiseEnergy::acceptStep() {
    controls_.swap(trial_);
    std::swap(derivatives_, trialDerivatives_);
    value_ = trialValue_;
    isDifferentiated_ = isTrialDifferentiated_;
}

bool CellwiseEnergy::isRough() const {
    return problem_.options.quadrature != Quadrature::Samples && !rule_.isExact();
}

void CellwiseEnergy::setRule(const SampleRule& rule) {
    rule_ = rule;
    integrals_->setRule(rule);
    isDifferentiated_ = false;
}

void CellwiseEnergy::makeExact() {
    if (isRough()) {
        setRule({});
    }
}

void CellwiseEnergy::freezeDirections(double freshShare) {
    if (problem_.options.bending == Bending::Ambient) {
        return;
    }
    std::optional<BendingDirections> fresh =
        bendingDirectionsAlong(problem_, space(), controls_, rule_);
    if (!fresh && isRough()) {
        makeExact();
        fresh = bendingDirectionsAlong(problem_, space(), controls_, rule_);
    }
    if (!fresh) {
        return;
    }
    if (!directions_.samples.empty() && freshShare < 1.0) {
        for (BendingDirections::Sample& sample : fresh->samples) {
            sample.direction = (freshShare * sample.direction +
                                (1.0 - freshShare) * directions_.at(sample.parameter))
                                   .normalized();
        }
    }
    directions_ = std::move(*fresh);
    integrals_->setDirections(directions_);
    isDifferentiated_ = false;
}

CurveDistance CellwiseEnergy::trace() {
    return measureDistance(traceStartOf(problem_), space(), controls_);
}

KnotDemand CellwiseEnergy::refinementGain() {
    KnotDemand gain;
    gain.perSpan.assign(space().spanCount(), 0.0);
    SplineSpace halved(
        space().degree(),
        space().closed(),
        halveSpans(space(), std::vector<char>(space().spanCount(), 1), 0.0)
    );
    ControlPoints refined = refine(space(), controls_, halved);
    CellwiseEnergy fine(problem_, {std::move(halved), std::move(refined)}, tensionFloor_);
    fine.setRule(isRough() ? segmentsOfSpans(kCellwiseEnergy.roughSegments / 2) : rule_);
    fine.setWeights(weights_);
    const double negligible =
        isRough() ? kCellwiseEnergy.negligibleSampledGain : kCellwiseEnergy.negligibleGain;
    const double savable = value_.scale - tensionFloor_;
    const auto withVerdict = [&](double largestMove) {
        gain.isNegligible = gain.total < negligible * savable ||
                            (problem_.options.tension > 0.0 && largestMove < restingMove_);
        return gain;
    };
    if (!directions_.samples.empty()) {
        std::optional<BendingDirections> resampled =
            bendingDirectionsAlong(problem_, fine.space(), fine.controls(), fine.rule_);
        if (!resampled) {
            return withVerdict(0.0);
        }
        for (BendingDirections::Sample& sample : resampled->samples) {
            sample.direction = directions_.at(sample.parameter);
        }
        fine.integrals_->setDirections(*resampled);
    }
    if (!fine.differentiate().inside) {
        return withVerdict(0.0);
    }
    // The negative part can make the finer Hessian nearly singular, and the promise without bound:
    // leave it out.
    static constexpr std::array<double, 1> kNoNegative = {0.0};
    NewtonPolicy policy = cellwiseNewton();
    policy.negativeShares = kNoNegative;
    const std::optional<NewtonStep> step = newtonStep(fine, problem_.options.interpolation, policy);
    if (!step) {
        return withVerdict(0.0);
    }
    gain.total = -0.5 * fine.derivatives().gradient.dot(step->direction);
    double largestMove = 0.0;
    for (Eigen::Index c = 0; c < fine.space().controlCount(); ++c) {
        largestMove = std::max(largestMove, step->direction.segment<3>(3 * c).norm());
    }
    // The fall is half the step's energy norm, which the spans share.
    for (int span = 0; span < fine.space().spanCount(); ++span) {
        const SpanVector local = unknownsOf(fine.space(), span, step->direction);
        gain.perSpan[span / 2] +=
            0.5 *
            local.dot(dense(fine.derivatives().hessian[span], fine.space().basisCount()) * local);
    }
    return withVerdict(largestMove);
}

void CellwiseEnergy::insertKnots(SplineSpace finer) {
    const auto coarse = std::exchange(basis_, std::make_unique<Basis>(problem_, std::move(finer)));
    controls_ = refine(coarse->space, controls_, space());
    integrals_ = std::make_unique<CellwiseIntegrals>(problem_, space(), picks().rows(), rule_);
    isDifferentiated_ = false;
}

}  // namespace bspline_curve
