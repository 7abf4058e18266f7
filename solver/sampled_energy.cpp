// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/sampled_energy.h"

#include "projection/fibre_tracer.h"
#include "solver/knot_removal.h"
#include "solver/problem_traces.h"
#include "utility/worker_thread.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace bspline_curve {
namespace {

struct SampledEnergyConstants {
    /// Spans are damped that have more than this share of all energy that was not foreseen.
    double leastModelError = 0.01;
    /// Where that was not enough the damping grows by this factor at least.
    double dampingGrowth = 2.0;
    /// Share of the damping that stays for the next step.
    double dampingKept = 0.25;
    /// More knots no longer change the curve where bulges of all spans would lower the energy by
    /// less than this share of it; with twice as much curves bend more for few knots less.
    double negligibleGain = 0.01;
    /// Of quadratic splines, whose bending falls with the square of the span alone: with 0.01 they
    /// have three times the knots for the same curve.
    double negligibleQuadraticGain = 0.03;
    /// Without needless knots samples may be so far away, in tolerances: less keeps a tenth more
    /// knots, with more curves leave the tolerance between samples.
    double heightWithFewer = 0.85;
    /// And the curve may bend by this share more than before, and than one whose length times the
    /// integral of squared curvature is the floor: what bends less looks straight.
    double bendingWithFewer = 0.01, bendingFloor = 1.0;
};

constexpr SampledEnergyConstants kSampledEnergy;

}  // namespace

SampledEnergy::SampledEnergy(
    const CurveProblem& problem,
    SplineCurve curve,
    const InitialPath& initialPath,
    double heightUnit,
    int segments
)
    : Energy(problem, std::move(curve.space)),
      projector_(*problem.extended, problem.patches),
      heightUnit_(heightUnit),
      segments_(segments),
      integrals_(std::make_unique<SampledIntegrals>(problem, space(), heightUnit, segments)),
      now_{
          std::move(curve.controls),
          std::vector<FootPoint>(integrals_->sampleCount()),
          std::vector<FootFrame>(integrals_->sampleCount()),
          {},
          {}
      },
      damping_(space().spanCount(), 0.0) {
    std::size_t near = 0;
    for (int sample = 0; sample < integrals_->sampleCount(); ++sample) {
        const double t = integrals_->parameter(sample);
        while (near + 1 < initialPath.points.size() &&
               initialPath.points[near + 1].parameter <= t) {
            ++near;
        }
        now_.feet[sample] = FootPoint::at(initialPath.points[near].point);
    }
    facesSeen_ += integrals_->follow(projector_, now_);
}

void SampledEnergy::setControls(const ControlPoints& controls) {
    now_.controls = controls;
    facesSeen_ += integrals_->follow(projector_, now_);
}

EnergyValue SampledEnergy::valueOf(const EnergyTerms& terms) const {
    const double total = integrals_->total(terms, weights_);
    return {std::isfinite(total), total, integrals_->scale(terms, weights_), terms};
}

EnergyValue SampledEnergy::differentiate() {
    for (double& damping : damping_) {
        damping *= kSampledEnergy.dampingKept;
    }
    differentiateWith(1.0);
    return valueOf(terms_);
}

void SampledEnergy::differentiateWith(double negativeShare) {
    negativeShare_ = negativeShare;
    terms_ = integrals_->differentiate(
        now_, weights_, negativeShare, derivatives_.gradient, derivatives_.hessian
    );
    integrals_->addDamping(damping_, derivatives_.hessian);
}

const std::vector<SpanBlocks>& SampledEnergy::hessian(double negativeShare) {
    if (negativeShare != negativeShare_) {
        differentiateWith(negativeShare);
    }
    return derivatives_.hessian;
}

EnergyValue SampledEnergy::tryStep(const Eigen::VectorXd& step, double length) {
    trial_ = now_;
    Eigen::Map<Eigen::VectorXd>(trial_.controls.data(), trial_.controls.size()) += length * step;
    facesSeen_ += integrals_->follow(projector_, trial_);
    return valueOf(integrals_->terms(trial_, now_.frames, weights_));
}

bool SampledEnergy::dampModelErrors() {
    const std::vector<SampledIntegrals::ModelError> modelErrors =
        integrals_->modelErrors(now_, trial_, weights_);
    double all = 0.0;
    for (const SampledIntegrals::ModelError& modelError : modelErrors) {
        all += std::max(0.0, modelError.energy);
    }
    std::vector<double> more(modelErrors.size(), 0.0);
    for (std::size_t span = 0; span < modelErrors.size(); ++span) {
        const SampledIntegrals::ModelError& modelError = modelErrors[span];
        if (modelError.squaredWay > 0.0 &&
            modelError.energy > kSampledEnergy.leastModelError * all) {
            const double needed = std::max(
                kSampledEnergy.dampingGrowth * damping_[span],
                modelError.energy / modelError.squaredWay
            );
            more[span] = needed - damping_[span];
            damping_[span] = needed;
        }
    }
    integrals_->addDamping(more, derivatives_.hessian);
    return all > 0.0;
}

CurveDistance SampledEnergy::measure() {
    CurveDistance distance;
    distance.largest = integrals_->largestHeight(now_);
    return distance;
}

CurveDistance SampledEnergy::trace() {
    picks().meet(now_.controls);  // rounding of many steps
    return traceOf(space(), controls());
}

CurveDistance SampledEnergy::traceOf(
    const SplineSpace& splines, const ControlPoints& controls
) const {
    return problem_.shell != nullptr
               ? measureDistance(traceStartOf(problem_), splines, controls)
               : measureAlongFibres(
                     fibreStartOf(problem_), splines, controls, footAtMiddle(splines, controls)
                 );
}

// The start of the middle span of a spline near to this one, from the sample there.
FootOfSpan SampledEnergy::footAtMiddle(
    const SplineSpace& splines, const ControlPoints& controls
) const {
    const int span = splines.spanCount() / 2;
    const int near = space().spanAt(splines.breaks()[span]);
    const int sample = near * integrals_->samplesPerSpan();
    FootPoint foot = now_.feet[sample];
    FootFrame frame = now_.frames[sample];
    const Vec3 start = splines.polynomial(controls, span).coefficients[0];
    FibreProjector::predict(start - now_.positions[sample], frame, foot);
    projector_.move(start, foot, frame);
    return {span, foot};
}

std::optional<TracedSpline> SampledEnergy::withFewerKnots() {
    if (problem_.keepsKnots || problem_.options.fairness != Fairness::Curvature ||
        hasPull(problem_)) {
        return std::nullopt;
    }
    const double tolerance = problem_.distanceTolerance;
    const SplineCurve before{space(), controls()};
    KnotRemoval removal(
        before,
        problem_.picks,
        integrals_->seen(now_),
        {kSampledEnergy.heightWithFewer * tolerance,
         tolerance,  // with twice as much a hundredth fewer knots, but circles are less round
         kSampledEnergy.bendingWithFewer,
         kSampledEnergy.bendingFloor}
    );
    TracedSpline fewer{removal.run(), {}};
    const auto isShorter = [&] { return fewer.curve.space.spanCount() < space().spanCount(); };
    if (!isShorter()) {
        return std::nullopt;
    }
    fewer.distance = traceOf(fewer.curve.space, fewer.curve.controls);
    if (fewer.distance.largest >= tolerance) {
        fewer.curve = removal.withKnotsBack(farSpans(fewer.distance, tolerance));
        if (!isShorter()) {
            return std::nullopt;
        }
        fewer.distance = traceOf(fewer.curve.space, fewer.curve.controls);
    }
    return fewer.distance.largest < tolerance ? std::optional(std::move(fewer)) : std::nullopt;
}

KnotDemand SampledEnergy::refinementGain() {
    KnotDemand gain;
    gain.perSpan.resize(space().spanCount());
    forEach(problem_.side, space().spanCount(), kSpansAtOnce, [&](int span) {
        gain.perSpan[span] = integrals_->refinementGain(now_, weights_, span);
    });
    gain.total = std::accumulate(gain.perSpan.begin(), gain.perSpan.end(), 0.0);
    const double scale = valueOf(integrals_->terms(now_, now_.frames, weights_)).scale;
    const double negligible = space().degree() > 2 ? kSampledEnergy.negligibleGain
                                                   : kSampledEnergy.negligibleQuadraticGain;
    gain.isNegligible = gain.total < negligible * scale;
    return gain;
}

void SampledEnergy::insertKnots(SplineSpace finer) {
    const auto coarse = std::exchange(basis_, std::make_unique<Basis>(problem_, std::move(finer)));
    const auto before = std::exchange(
        integrals_, std::make_unique<SampledIntegrals>(problem_, space(), heightUnit_, segments_)
    );
    const FootedSpline old = std::move(now_);
    now_ = {
        refine(coarse->space, old.controls, space()),
        std::vector<FootPoint>(integrals_->sampleCount()),
        std::vector<FootFrame>(integrals_->sampleCount()),
        {},
        {}
    };
    facesSeen_ += integrals_->followRefined(projector_, *before, old, now_);
    damping_.assign(space().spanCount(), 0.0);
}

}  // namespace bspline_curve
