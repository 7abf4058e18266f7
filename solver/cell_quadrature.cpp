// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/curve_tracer.h"
#include "solver/gauss_rule.h"
#include "solver/quadrature.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace bspline_curve {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

// A curve that grazes a wall, or hardly moves, has a kink term without bound; this is the least |n
// . P'| that counts, relative to |P'|, and |P'| relative to the length of the polygon of picks (the
// curve turns back in a cusp: with terms of 1e20 no factorisation succeeds).
constexpr double kLeastCrossingCosine = 0.05;
constexpr double kLeastSpeed = 0.1;
// A jump of the gradient by less than this share of it is rounding: the faces next to the wall are
// coplanar, or what changes there does not enter the integrand.
constexpr double kLeastJump = 1e-11;

// Where a curve passes from one cell into the next.
struct WallCrossing {
    const ShellCell& from;
    const ShellCell& to;
    int wall;  // of `from`
    const PolynomialCurve& curve;
    int span;
    double tau;
};

// At a wall the integrand keeps its value and its gradient jumps along the wall's normal; moving
// the curve moves the crossing, which gives the second derivative q (n . dP)^2 with q = jump / |n .
// P'|.
void addKink(
    const CurveProblem& problem,
    const SplineSpace& space,
    const EnergyWeights& weights,
    const WallCrossing& crossing,
    DerivativeCollector& collector
) {
    const Vec3 normal = -crossing.from.walls[at(crossing.wall)].gradient.normalized();
    const Vec3 p = crossing.curve.at(crossing.tau);
    const Vec3 before = CellIntegrand(problem, weights, crossing.from).gradient(p);
    const Vec3 after = CellIntegrand(problem, weights, crossing.to).gradient(p);
    const double jump = (after - before).dot(normal);
    if (std::abs(jump) <= kLeastJump * before.norm()) {
        return;
    }
    const Vec3 velocity =
        crossing.curve.derivativeAt(crossing.tau) / space.spanLength(crossing.span);
    const double speed = std::max(velocity.norm(), kLeastSpeed * problem.chordLength);
    const double across = std::max(std::abs(normal.dot(velocity)), kLeastCrossingCosine * speed);
    collector.addKink(crossing.span, crossing.tau, normal, jump / across);
}

}  // namespace

bool integrateCells(
    const CurveProblem& problem,
    const SplineSpace& space,
    const ControlPoints& controls,
    const EnergyWeights& weights,
    EnergyTerms& terms,
    EnergyDerivatives* derivatives
) {
    bool belowBarrier = true;
    std::optional<DerivativeCollector> collector;
    if (derivatives != nullptr) {
        collector.emplace(space, *derivatives);
    }
    const auto onPiece =
        [&](
            int span, const PolynomialCurve& curve, const ShellCell& cell, double tau0, double tau1
        ) {
            const double length = (tau1 - tau0) * space.spanLength(span);
            const CellIntegrand integrand(problem, weights, cell);
            for (std::size_t i = 0; i < kGaussNodes.size(); ++i) {
                const double tau = tau0 + (tau1 - tau0) * kGaussNodes[i];
                const double weight = kGaussWeights[i] * length;
                if (!collector) {
                    belowBarrier &= integrand.add(curve.at(tau), weight, terms);
                    continue;
                }
                PointDerivatives point;
                belowBarrier &= integrand.add(curve.at(tau), weight, terms, point);
                collector->add(span, tau, point);
            }
        };
    const auto onCrossing = [&](int span,
                                const PolynomialCurve& curve,
                                const ShellCell& from,
                                const ShellCell& to,
                                double tau,
                                int wall) {
        if (collector) {
            addKink(problem, space, weights, {from, to, wall, curve, span, tau}, *collector);
        }
    };
    const int spans = traceCurve(problem, space, controls, onPiece, onCrossing);
    if (collector) {
        collector->finish();
    }
    return spans == space.spanCount() && belowBarrier;
}

}  // namespace bspline_curve
