// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/weights.h"

#include <algorithm>
#include <limits>

namespace bspline_curve {
namespace {

// Geometric schedule for alpha. Measured over 24 curves on 8 scans: factor 3 and 6 give the same
// bending (0.55 and 0.54 of the reference), 6 in fewer rounds; 100 lets a stiff spline slide
// sideways.
constexpr double kFirstAlpha = 10.0;
constexpr double kAlphaFactor = 6.0;
// Bounds of (18), and the same scheme for beta.
constexpr double kAlphaMin = 1.0;
constexpr double kAlphaMax = 1e8;
constexpr double kBetaMin = 10.0;
constexpr double kBetaMax = 1e10;
constexpr double kFirstBeta = 1e6;
// epsilon_b of (12).
constexpr double kBarrierMargin = 0.02;

double adaptive(double others, double own, double least, double most) {
    const double ratio = own > 0.0 ? others / own : std::numeric_limits<double>::infinity();
    return std::min(least * std::max(ratio, 1.0), most);
}

double barrierWidth(const SolverOptions& options, double largestHeight) {
    return options.barrierWidth == BarrierWidth::Full
               ? 1.0
               : std::min(largestHeight + kBarrierMargin, 1.0);
}

}  // namespace

EnergyWeights firstWeights(const SolverOptions& options, double largestHeight) {
    EnergyWeights weights;
    weights.alpha = options.distanceWeight == DistanceWeight::Schedule ? kFirstAlpha : kAlphaMin;
    weights.beta = options.interpolation == Interpolation::Constraint ? 0.0 : kFirstBeta;
    weights.barrierWidth = barrierWidth(options, largestHeight);
    weights.outsideAllowed = largestHeight >= 1.0;
    return weights;
}

EnergyWeights nextWeights(
    const SolverOptions& options,
    const EnergyWeights& now,
    const EnergyTerms& terms,
    double mu,
    double largestHeight,
    bool near
) {
    EnergyWeights next = now;
    if (options.distanceWeight == DistanceWeight::Schedule) {
        next.alpha = near ? now.alpha : now.alpha * kAlphaFactor;
    } else {
        const double others = terms.internal + mu * terms.external + now.beta * terms.fit;
        next.alpha = adaptive(others, terms.distance, kAlphaMin, kAlphaMax);
    }
    if (options.interpolation == Interpolation::Penalty) {
        const double others = terms.internal + mu * terms.external + now.alpha * terms.distance;
        next.beta = adaptive(others, terms.fit, kBetaMin, kBetaMax);
    }
    next.barrierWidth = barrierWidth(options, largestHeight);
    next.outsideAllowed = largestHeight >= 1.0;
    return next;
}

}  // namespace bspline_curve
