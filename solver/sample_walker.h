// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/polynomial_trace.h"
#include "shell/shell_boundary.h"
#include "solver/curve_problem.h"
#include "solver/sample_rule.h"
#include "spline/spline_space.h"

#include <cmath>
#include <optional>
#include <utility>

namespace bspline_curve {

/// Follows samples of a curve through the shell, from each to the next by a straight walk (the
/// paper's ray tracing), and back in through the nearest point of the boundary where the curve was
/// outside. Without CurveProblem::boundary it stays outside.
class SampleWalker {
public:
    SampleWalker(
        const CurveProblem& problem, const SplineSpace& space, const ControlPoints& controls
    )
        : problem_(problem), here_(problem.picks.front().position) {
        state_.cell = ShellCell(*problem.shell, problem.picks.front().point);
        moveTo(space.polynomial(controls, 0).coefficients[0]);
    }

    void moveTo(const Vec3& p) {
        if (!outside_ && walk(here_, p)) {
            here_ = p;
            return;
        }
        if (problem_.boundary == nullptr) {
            outside_ = true;
            return;
        }
        const ShellBoundary::Nearest nearest = problem_.boundary->nearest(p);
        const std::optional<ShellCell> entry =
            ShellCell::find(*problem_.shell, nearest.tet, nearest.position);
        if (!entry) {
            outside_ = true;  // no face there: the sample before stands for this one
            return;
        }
        state_ = {*entry};
        // Inside where the walk from the boundary ends inside.
        outside_ = !walk(nearest.position, p);
        if (outside_) {
            state_ = {*entry};
        }
        here_ = outside_ ? nearest.position : p;
    }

    [[nodiscard]] const ShellCell& cell() const { return state_.cell; }

    [[nodiscard]] bool outside() const { return outside_; }

    /// The sample itself, or its nearest point of the boundary.
    [[nodiscard]] const Vec3& position() const { return here_; }

    /// d of the sample (10), as the options say; 1 where it is outside.
    [[nodiscard]] double relativeHeight() const {
        if (outside_) {
            return 1.0;
        }
        return problem_.options.relativeHeight == RelativeHeight::Linear
                   ? state_.cell.linearHeight(here_)
                   : std::abs(state_.cell.relativeHeight(here_));
    }

private:
    bool walk(const Vec3& from, const Vec3& to) {
        return walkStraight(*problem_.shell, from, to, state_);
    }

    const CurveProblem& problem_;
    TraceState state_;
    Vec3 here_;
    bool outside_ = false;
};

/// Follows all samples of a spline, and calls visit(walker, curve, span, tau, weight) at each, with
/// the span's polynomial; else as forEachSample().
template <class Visit>
bool walkSamples(
    const CurveProblem& problem,
    const SplineSpace& space,
    const ControlPoints& controls,
    const SampleRule& rule,
    const Visit& visit
) {
    SampleWalker walker(problem, space, controls);
    int current = -1;
    PolynomialCurve curve;
    return forEachSample(space, rule, [&](int span, double tau, double weight) {
        if (span != current) {
            current = span;
            curve = space.polynomial(controls, span);
        }
        walker.moveTo(curve.at(tau));
        return visit(std::as_const(walker), std::as_const(curve), span, tau, weight);
    });
}

/// Largest relative height of the samples; 1 where one is outside.
[[nodiscard]] double largestSampledHeight(
    const CurveProblem& problem,
    const SplineSpace& space,
    const ControlPoints& controls,
    const SampleRule& rule
);

}  // namespace bspline_curve
