// SPDX-License-Identifier: GPL-3.0-or-later
#include "projection/cell_tracer.h"
#include "solver/problem_traces.h"
#include "solver/quadrature.h"
#include "spline/gauss_rule.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace bspline_curve {
namespace {

// A curve that grazes a wall, or hardly moves, has a kink term without bound; this is the least |n
// . P'| that counts, relative to |P'|, and |P'| relative to the length of the polygon of picks (the
// curve turns back in a cusp: with terms of 1e20 no factorisation succeeds).
constexpr double kLeastCrossingCosine = 0.05;
constexpr double kLeastSpeed = 0.1;
// A jump of the gradient by less than this share of it is rounding: the faces next to the wall are
// coplanar, or what changes there does not enter the integrand.
constexpr double kLeastJump = 1e-11;

// Near a pole the Gauss points of a long piece miss how steeply the integrand rises at its end: the
// curve then rests on the pole, which the energy does not see, and no step leads away from it. Of
// 85 curves through random picks on a bunny this befell three, and line searches of others stalled.
// Pieces that come nearer to a pole than this are halved until the room changes by no more than a
// factor in each part, where three points give four digits. 0.3 in place of 0.1 gives the same.
constexpr double kNearPole = 0.1;
constexpr double kRoomFactor = 2.0;
constexpr int kMaxHalvings = 40;

// Calls visit(from, to) for the parts of a piece, in order.
template <class Visit>
void forEachPart(
    const CellIntegrand& integrand,
    const PolynomialCurve& curve,
    double from,
    double to,
    const Visit& visit,
    int depth = 0
) {
    const double middle = 0.5 * (from + to);
    const auto [least, most] = std::minmax(
        {integrand.room(curve.at(from)),
         integrand.room(curve.at(middle)),
         integrand.room(curve.at(to))}
    );
    const bool isSteep = least > 0.0 && least < kNearPole && most > kRoomFactor * least;
    if (!isSteep || depth == kMaxHalvings) {
        visit(from, to);
        return;
    }
    forEachPart(integrand, curve, from, middle, visit, depth + 1);
    forEachPart(integrand, curve, middle, to, visit, depth + 1);
}

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
    const Vec3 normal = -crossing.from.walls[crossing.wall].gradient.normalized();
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
            if (!belowBarrier) {
                return;  // nothing that is added now is used
            }
            const CellIntegrand integrand(problem, weights, cell);
            forEachPart(integrand, curve, tau0, tau1, [&](double from, double to) {
                const double length = (to - from) * space.spanLength(span);
                for (std::size_t i = 0; i < kGaussNodes.size(); ++i) {
                    const double tau = from + (to - from) * kGaussNodes[i];
                    const double weight = kGaussWeights[i] * length;
                    if (!collector) {
                        belowBarrier &= integrand.add(curve.at(tau), weight, terms);
                        continue;
                    }
                    PointDerivatives point;
                    belowBarrier &= integrand.add(curve.at(tau), weight, terms, point);
                    collector->add(span, tau, point);
                }
            });
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
    const int spans = traceCurve(traceStartOf(problem), space, controls, onPiece, onCrossing);
    if (collector) {
        collector->finish();
    }
    return spans == space.spanCount() && belowBarrier;
}

}  // namespace bspline_curve
