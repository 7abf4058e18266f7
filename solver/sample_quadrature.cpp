// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/shell_boundary.h"
#include "solver/curve_tracer.h"
#include "solver/quadrature.h"

#include <array>
#include <optional>

namespace bspline_curve {
namespace {

// eta of the paper's Sect. 4.2.
constexpr double kHeightScale = 0.99;
// Two Gauss points on each of the M segments of (14)-(16).
constexpr std::array<double, 2> kPairNodes = {0.21132486540518712, 0.78867513459481288};

// Follows samples of a curve through the shell, from each to the next by a straight walk, and back
// in through the nearest point of the boundary where the curve was outside.
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

private:
    bool walk(const Vec3& from, const Vec3& to) {
        return walkStraight(*problem_.shell, from, to, state_);
    }

    const CurveProblem& problem_;
    TraceState state_;
    Vec3 here_;
    bool outside_ = false;
};

}  // namespace

bool integrateSamples(
    const CurveProblem& problem,
    const SplineSpace& space,
    const ControlPoints& controls,
    const EnergyWeights& weights,
    EnergyTerms& terms,
    EnergyDerivatives* derivatives
) {
    SampleWalker walker(problem, space, controls);
    const int segments = problem.options.samplesPerSpan;
    bool belowBarrier = true;
    std::optional<DerivativeCollector> collector;
    if (derivatives != nullptr) {
        collector.emplace(space, *derivatives);
    }
    for (int span = 0; span < space.spanCount(); ++span) {
        const PolynomialCurve curve = space.polynomial(controls, span);
        const double weight = 0.5 * space.spanLength(span) / segments;
        for (int i = 0; i < 2 * segments; ++i) {
            const int segment = i / 2;
            const double tau = (segment + kPairNodes[static_cast<std::size_t>(i % 2)]) / segments;
            walker.moveTo(curve.at(tau));
            if (walker.outside() && !weights.outsideAllowed) {
                return false;
            }
            const double scale = weights.outsideAllowed ? kHeightScale : 1.0;
            const CellIntegrand integrand(problem, weights, walker.cell(), scale);
            // Outside, the terms are those of the boundary point and do not change with the sample.
            if (!collector || walker.outside()) {
                belowBarrier &= integrand.add(walker.position(), weight, terms);
                continue;
            }
            PointDerivatives point;
            belowBarrier &= integrand.add(walker.position(), weight, terms, point);
            collector->add(span, tau, point);
        }
    }
    if (collector) {
        collector->finish();
    }
    return belowBarrier;
}

}  // namespace bspline_curve
