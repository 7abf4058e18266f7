// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/paper/paper_settings.h"

#include "solver/paper/feature_knots.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace bspline_curve {
namespace {

struct PaperConstants {
    /// Bounds of alpha (18), which is dimensionless; the first is its first value as well.
    double alphaMin = 1.0, alphaMax = 1e8;
    /// The same for beta, and its first value.
    double betaMin = 10.0, betaMax = 1e10, betaFirst = 1e6;
    /// epsilon_b of (12), of the relative height.
    double barrierMargin = 0.02;
    /// Rules 1 and 2 for the end of knot insertion: share of the energy below which the features of
    /// all spans, or the change of their sum, are negligible.
    double negligibleFeature = 0.03;
};

constexpr PaperConstants kPaper;

double adaptive(double others, double own, double least, double most) {
    const double ratio = own > 0.0 ? others / own : std::numeric_limits<double>::infinity();
    return std::min(least * std::max(ratio, 1.0), most);
}

}  // namespace

void PaperSettings::setBarrier(double largestHeight, EnergyWeights& weights) const {
    weights.barrierWidth = problem_.options.barrierWidth == BarrierWidth::Full
                               ? 1.0
                               : std::min(largestHeight + kPaper.barrierMargin, 1.0);
    weights.outsideAllowed = largestHeight >= 1.0;
}

void PaperSettings::adjustFirst(double largestHeight, EnergyWeights& first) const {
    if (problem_.options.distanceWeight == DistanceWeight::Adaptive) {
        first.alpha = kPaper.alphaMin;
    }
    if (problem_.options.interpolation == Interpolation::Penalty) {
        first.beta = kPaper.betaFirst;
    }
    setBarrier(largestHeight, first);
}

void PaperSettings::adjustNext(
    const EnergyWeights& before, const EnergyTerms& terms, double largestHeight, EnergyWeights& next
) const {
    const double rest = terms.internal + fieldWeight(problem_) * terms.external;
    if (problem_.options.distanceWeight == DistanceWeight::Adaptive) {
        next.alpha = adaptive(
            rest + before.beta * terms.fit, terms.distance, kPaper.alphaMin, kPaper.alphaMax
        );
    }
    if (problem_.options.interpolation == Interpolation::Penalty) {
        next.beta = adaptive(
            rest + before.alpha * terms.distance, terms.fit, kPaper.betaMin, kPaper.betaMax
        );
    }
    setBarrier(largestHeight, next);
}

std::vector<double> PaperSettings::chooseBreaks(
    const Energy& energy, const EnergyWeights& weights, double scale, bool isNear
) {
    const KnotDemand feature =
        featureFunction(problem_, energy.space(), energy.controls(), weights);
    const double before = std::exchange(feature_, feature.total);
    // The paper's rules 1 and 2; rule 3 is that insertByFeature finds no room.
    const double threshold = kPaper.negligibleFeature * scale;
    const bool isSmall =
        std::ranges::all_of(feature.perSpan, [&](double value) { return value < threshold; });
    if (isNear && (isSmall || std::abs(feature.total - before) < threshold)) {
        return energy.space().breaks();
    }
    return insertByFeature(energy.space(), feature, problem_.options.minimumSpan);
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
