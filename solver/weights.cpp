// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/weights.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bspline_curve {
namespace {

// Geometric schedule for alpha. Measured over 24 curves on 8 scans: factor 3 and 6 give the same
// bending (0.55 and 0.54 of the reference), 6 in fewer rounds; 100 lets a stiff spline slide
// sideways.
constexpr double kFirstAlpha = 10.0;
constexpr double kAlphaFactor = 6.0;
// In gentle steps, what is needed to come so far below the tolerance: over the same curves, in
// simplified shells, exponent 1.5 gives the same bending as 2 with fewer knots, in 20 % less time.
// In thin shells all exponents made curves depend more on how the mesh is triangulated.
constexpr double kAimedRatio = 0.8;
constexpr double kDistanceExponent = 1.5;
constexpr double kLeastAlphaFactor = 1.5;
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

double alphaStep(double distanceRatio, bool gentle) {
    if (distanceRatio < 1.0) {
        return 1.0;
    }
    const double needed = std::pow(distanceRatio / kAimedRatio, kDistanceExponent);
    return gentle ? std::clamp(needed, kLeastAlphaFactor, kAlphaFactor) : kAlphaFactor;
}

EnergyWeights nextWeights(
    const SolverOptions& options,
    const EnergyWeights& now,
    const EnergyTerms& terms,
    double mu,
    double largestHeight,
    double alphaStep
) {
    EnergyWeights next = now;
    if (options.distanceWeight == DistanceWeight::Schedule) {
        next.alpha = now.alpha * alphaStep;
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
