// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/paper/feature_knots.h"

#include "projection/cell_tracer.h"
#include "solver/barrier.h"
#include "solver/problem_traces.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace bspline_curve {
namespace {

// The barrier in the feature function is cut off here, below its pole.
constexpr double kHighest = 0.999;

}  // namespace

KnotDemand featureFunction(
    const CurveProblem& problem,
    const SplineSpace& space,
    const ControlPoints& controls,
    const EnergyWeights& weights
) {
    KnotDemand feature;
    feature.perSpan.assign(space.spanCount(), 0.0);
    const double tension = problem.options.tension;
    const auto onPiece = [&](int span,
                             const PolynomialCurve& curve,
                             const ShellCell& cell,
                             double tau0,
                             double tau1) {
        const double length = space.spanLength(span);
        const double tau = 0.5 * (tau0 + tau1);
        const Triangle& face = problem.extended->faces[cell.face];
        // Within a cell the shadow is an affine image of the curve, so are its derivatives.
        const auto shadowOf = [&](const Vec3& derivative) {
            Vec3 image = Vec3::Zero();
            for (std::size_t corner = 0; corner < 3; ++corner) {
                image += cell.shadowForm(corner).gradient.dot(derivative) *
                         problem.extended->vertices[face[corner]];
            }
            return image;
        };
        const Vec3 first = curve.derivativeAt(tau) / length;
        const Vec3 second = curve.secondDerivativeAt(tau) / (length * length);
        const double height =
            std::min(std::abs(cell.relativeHeight(curve.at(tau))), kHighest * weights.barrierWidth);
        feature.perSpan[span] += (tau1 - tau0) * length *
                                 (tension * (first - shadowOf(first)).squaredNorm() +
                                  (1.0 - tension) * (second - shadowOf(second)).squaredNorm() +
                                  weights.alpha * barrierValue(height, weights.barrierWidth));
    };
    traceCurve(
        traceStartOf(problem),
        space,
        controls,
        onPiece,
        [](int, const PolynomialCurve&, const ShellCell&, const ShellCell&, double, int) {}
    );
    feature.total = std::accumulate(feature.perSpan.begin(), feature.perSpan.end(), 0.0);
    return feature;
}

std::vector<double> insertByFeature(
    const SplineSpace& space, const KnotDemand& feature, double minimumSpan
) {
    const double average = feature.total / space.spanCount();  // (21), (22) with r = 1
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
