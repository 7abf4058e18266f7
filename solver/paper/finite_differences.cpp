// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/paper/finite_differences.h"

#include <algorithm>

namespace bspline_curve {
namespace {

// Near the ends of a span differences get shorter, down to this share of the usual step: with less,
// rounding would show.
constexpr double kLeastStep = 0.1;

}  // namespace

std::vector<SplineSpace::BasisMatrix> differenceProducts(
    const CurveProblem& problem, const SplineSpace& space, const SampleRule& rule
) {
    std::vector<SplineSpace::BasisMatrix> products(
        space.spanCount(), SplineSpace::BasisMatrix::Zero()
    );
    const double tension = problem.options.tension;
    const double scale = 2.0 / (problem.chordLength * problem.chordLength);
    (void)forEachSample(space, rule, [&](int span, double tau, double weight) {
        const double length = space.spanLength(span);
        const double segment = rule.isOfCurve ? 1.0 / rule.segments : length / rule.segments;
        const double half = 0.5 * std::min(1.0, segment / length);
        const double step = std::clamp(std::min(tau, 1.0 - tau), kLeastStep * half, half);
        const double centre = std::clamp(tau, step, 1.0 - step);
        const SplineSpace::BasisValues before = space.basisAt(span, centre - step);
        const SplineSpace::BasisValues here = space.basisAt(span, centre);
        const SplineSpace::BasisValues after = space.basisAt(span, centre + step);
        Eigen::Vector<double, kMaxBasis> first = Eigen::Vector<double, kMaxBasis>::Zero();
        Eigen::Vector<double, kMaxBasis> second = Eigen::Vector<double, kMaxBasis>::Zero();
        const double h = step * length;
        for (int j = 0; j < space.basisCount(); ++j) {
            first[j] = (after[j] - before[j]) / (2.0 * h);
            second[j] = (after[j] - 2.0 * here[j] + before[j]) / (h * h);
        }
        products[span] += scale * weight * tension * first * first.transpose();
        products[span] += scale * weight * (1.0 - tension) * second * second.transpose();
        return true;
    });
    return products;
}

}  // namespace bspline_curve
