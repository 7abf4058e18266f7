// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/curve_problem.h"
#include "spline/gauss_rule.h"
#include "spline/spline_space.h"

#include <algorithm>

namespace bspline_curve {

/// Where integrals along a curve are sampled: at Gauss points on even segments of each span, or of
/// the whole curve. Without segments they are taken exactly, cell by cell.
struct SampleRule {
    int segments = 0;
    int points = 2;  ///< on each segment
    bool isOfCurve = false;

    [[nodiscard]] bool isExact() const { return segments == 0; }
};

/// Two Gauss points on each of so many even segments of every span.
[[nodiscard]] inline SampleRule segmentsOfSpans(int segments) {
    return {.segments = segments};
}

/// (14)-(16): M' Gauss points on each of the M segments of the curve.
[[nodiscard]] inline SampleRule segmentsOfCurve(const PaperOptions& options) {
    return {.segments = options.curveSegments, .points = options.gaussPoints, .isOfCurve = true};
}

/// No span gets shorter than this: epsilon_int of (23), and at samples of the curve one segment,
/// since a span without samples would leave the Hessian singular.
[[nodiscard]] inline double shortestSpan(const SolverOptions& options) {
    return options.quadrature == Quadrature::Samples
               ? std::max(options.minimumSpan, 1.0 / options.paper.curveSegments)
               : options.minimumSpan;
}

/// Calls visit(span, tau, weight) at each sample in order; tau in [0, 1] on the span, weights by
/// the curve's parameter: they sum up to 1. Stops where it returns false, and returns whether it
/// came to the end.
template <class Visit>
bool forEachSample(const SplineSpace& space, const SampleRule& rule, const Visit& visit) {
    const auto gauss = gaussRule(rule.points);
    if (!rule.isOfCurve) {
        for (int span = 0; span < space.spanCount(); ++span) {
            const double length = space.spanLength(span) / rule.segments;
            for (int segment = 0; segment < rule.segments; ++segment) {
                for (const GaussPoint& point : gauss) {
                    if (!visit(
                            span, (segment + point.node) / rule.segments, point.weight * length
                        )) {
                        return false;
                    }
                }
            }
        }
        return true;
    }
    int span = 0;
    const double length = 1.0 / rule.segments;
    for (int segment = 0; segment < rule.segments; ++segment) {
        for (const GaussPoint& point : gauss) {
            const double t = (segment + point.node) * length;
            while (span + 1 < space.spanCount() && t > space.breaks()[span + 1]) {
                ++span;
            }
            const double tau = (t - space.breaks()[span]) / space.spanLength(span);
            if (!visit(span, std::clamp(tau, 0.0, 1.0), point.weight * length)) {
                return false;
            }
        }
    }
    return true;
}

}  // namespace bspline_curve
