// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/paper/paper_settings.h"

#include "solver/paper/feature_knots.h"
#include "solver/sample_walker.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace bspline_curve {
namespace {

double adaptive(double others, double own, double least, double most) {
    const double ratio = own > 0.0 ? others / own : std::numeric_limits<double>::infinity();
    return std::min(least * std::max(ratio, 1.0), most);
}

}  // namespace

void PaperSettings::setBarrier(
    const Energy& energy, double largestHeight, EnergyWeights& weights
) const {
    const SolverOptions& options = problem_.options;
    const double height =
        options.quadrature == Quadrature::Samples
            ? largestSampledHeight(
                  problem_, energy.space(), energy.controls(), segmentsOfCurve(options.paper)
              )
            : largestHeight;
    weights.barrierWidth = options.barrierWidth == BarrierWidth::Full
                               ? 1.0
                               : std::min(height + options.paper.barrierMargin, 1.0);
    weights.outsideAllowed = height >= 1.0;
}

void PaperSettings::adjustFirst(Energy& energy, double largestHeight, EnergyWeights& first) const {
    const PaperOptions& paper = problem_.options.paper;
    if (problem_.options.interpolation == Interpolation::Penalty) {
        first.beta = paper.betaFirst;
    }
    setBarrier(energy, largestHeight, first);
    if (problem_.options.distanceWeight == DistanceWeight::Adaptive) {
        first.alpha = paper.alphaMin;
        energy.setWeights(first);
        const EnergyValue value = energy.differentiate();
        if (value.inside) {
            adjustAlpha(first, value.terms, first);
        }
    }
}

void PaperSettings::adjustAlpha(
    const EnergyWeights& before, const EnergyTerms& terms, EnergyWeights& next
) const {
    const double rest = terms.internal + fieldWeight(problem_) * terms.external;
    next.alpha = adaptive(
        rest + before.beta * terms.fit,
        terms.distance,
        problem_.options.paper.alphaMin,
        problem_.options.paper.alphaMax
    );
}

void PaperSettings::adjustNext(
    const EnergyWeights& before, const EnergyTerms& terms, EnergyWeights& next
) const {
    const PaperOptions& paper = problem_.options.paper;
    if (problem_.options.distanceWeight == DistanceWeight::Adaptive) {
        adjustAlpha(before, terms, next);
    }
    if (problem_.options.interpolation == Interpolation::Penalty) {
        const double rest = terms.internal + fieldWeight(problem_) * terms.external;
        next.beta =
            adaptive(rest + before.alpha * terms.distance, terms.fit, paper.betaMin, paper.betaMax);
    }
}

std::optional<std::vector<double>> PaperSettings::chooseBreaks(
    const Energy& energy, const EnergyWeights& weights, double scale, bool isNear
) {
    if (problem_.options.knotRule != KnotRule::FeatureFunction) {
        return std::nullopt;
    }
    const PaperOptions& paper = problem_.options.paper;
    const FeatureFunction feature =
        featureFunction(problem_, energy.space(), energy.controls(), weights);
    const double before = std::exchange(feature_, feature.total);
    // The paper's rules 1 and 2; rule 3 is that insertByFeature finds no room.
    const double threshold = paper.featureTolerance * scale;
    const bool isSmall =
        std::ranges::all_of(feature.perSpan, [&](double value) { return value < threshold; });
    if (isNear && (isSmall || std::abs(feature.total - before) < threshold)) {
        return energy.space().breaks();
    }
    return insertByFeature(
        energy.space(), feature, paper.knotRatio, shortestSpan(problem_.options)
    );
}

bool PaperSettings::arePicksNear(const Energy& energy) const {
    return problem_.options.interpolation != Interpolation::Penalty ||
           energy.picks().residual(energy.controls()).lpNorm<Eigen::Infinity>() <
               problem_.distanceTolerance;
}

double PaperSettings::meetPicks(Energy& energy, const NewtonPolicy& policy) const {
    if (problem_.options.interpolation != Interpolation::Penalty ||
        !energy.differentiate().inside) {
        return 0.0;
    }
    const std::optional<NewtonStep> step = newtonStep(energy, Interpolation::Constraint, policy);
    if (!step) {
        return 0.0;
    }
    const ControlPoints before = energy.controls();
    energy.tryStep(step->direction, 1.0);
    energy.acceptStep();
    return (energy.controls() - before).rowwise().norm().maxCoeff();
}

}  // namespace bspline_curve
