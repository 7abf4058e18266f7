// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/paper/feature_knots.h"

#include "solver/barrier.h"
#include "solver/sample_walker.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace bspline_curve {
namespace {

// The barrier in the feature function is cut off at this share of its width, below its pole.
constexpr double kHighest = 0.999;

// Within a cell the shadow is an affine image of the curve, so are its derivatives.
Vec3 shadowOf(const CurveProblem& problem, const ShellCell& cell, const Vec3& derivative) {
    const Triangle& face = problem.extended->faces[cell.face];
    Vec3 image = Vec3::Zero();
    for (std::size_t corner = 0; corner < 3; ++corner) {
        image += cell.shadowForm(corner).gradient.dot(derivative) *
                 problem.extended->vertices[face[corner]];
    }
    return image;
}

}  // namespace

FeatureFunction featureFunction(
    const CurveProblem& problem,
    const SplineSpace& space,
    const ControlPoints& controls,
    const EnergyWeights& weights
) {
    FeatureFunction feature;
    feature.perSpan.assign(space.spanCount(), 0.0);
    const double tension = problem.options.tension;
    const auto visit = [&](const SampleWalker& walker,
                           const PolynomialCurve& curve,
                           int span,
                           double tau,
                           double weight) {
        const double length = space.spanLength(span);
        const Vec3 first = curve.derivativeAt(tau) / length;
        const Vec3 second = curve.secondDerivativeAt(tau) / (length * length);
        const double height = std::min(walker.relativeHeight(), kHighest * weights.barrierWidth);
        const Vec3 firstOff = first - shadowOf(problem, walker.cell(), first);
        const Vec3 secondOff = second - shadowOf(problem, walker.cell(), second);
        feature.perSpan[span] +=
            weight * (tension * firstOff.squaredNorm() + (1.0 - tension) * secondOff.squaredNorm() +
                      weights.alpha * barrierValue(height, weights.barrierWidth));
        return true;
    };
    (void)walkSamples(problem, space, controls, segmentsOfCurve(problem.options.paper), visit);
    feature.total = std::accumulate(feature.perSpan.begin(), feature.perSpan.end(), 0.0);
    return feature;
}

std::vector<double> insertByFeature(
    const SplineSpace& space, const FeatureFunction& feature, double ratio, double minimumSpan
) {
    const double average = feature.total / (ratio * space.spanCount());  // (21), (22)
    std::vector<double> breaks{space.breaks().front()};
    for (int span = 0; span < space.spanCount(); ++span) {
        const double length = space.spanLength(span);
        const int wanted = average > 0.0 ? static_cast<int>(feature.perSpan[span] / average) : 0;
        const int allowed = static_cast<int>(length / minimumSpan) - 1;
        const int count = std::clamp(wanted, 0, std::max(0, allowed));
        for (int i = 1; i <= count; ++i) {
            breaks.push_back(space.breaks()[span] + length * i / (count + 1));
        }
        breaks.push_back(space.breaks()[span + 1]);
    }
    return breaks;
}

}  // namespace bspline_curve
