// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/internal_energy.h"

#include "projection/cell_tracer.h"
#include "solver/problem_traces.h"
#include "solver/sample_walker.h"
#include "solver/solve_variant.h"
#include "spline/gauss_rule.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bspline_curve {
namespace {

// The integrals over tau of the products of derivatives of tau^a and tau^b.
SplineSpace::BasisMatrix powerProducts(int order) {
    const auto falling = [order](int m) {
        double factor = 1.0;
        for (int i = 0; i < order; ++i) {
            factor *= m - i;
        }
        return factor;
    };
    SplineSpace::BasisMatrix products = SplineSpace::BasisMatrix::Zero();
    for (int a = order; a < kMaxBasis; ++a) {
        for (int b = order; b < kMaxBasis; ++b) {
            products(a, b) = falling(a) * falling(b) / (a + b - 2 * order + 1);
        }
    }
    return products;
}

Vec3 directionIn(const CurveProblem& problem, const ShellCell& cell, const Vec3& p) {
    return directionAt(*problem.shell, *problem.extended, {cell.face, cell.shadow(p)});
}

std::optional<BendingDirections> directionsInCells(
    const CurveProblem& problem, const SplineSpace& space, const ControlPoints& controls
) {
    BendingDirections result;
    const int spans = traceCurve(
        traceStartOf(problem),
        space,
        controls,
        [&](
            int span, const PolynomialCurve& curve, const ShellCell& cell, double tau0, double tau1
        ) {
            for (std::size_t i = 0; i < kGaussNodes.size(); ++i) {
                const double tau = tau0 + (tau1 - tau0) * kGaussNodes[i];
                result.samples.push_back(
                    {space.breaks()[span] + tau * space.spanLength(span),
                     kGaussWeights[i] * (tau1 - tau0) * space.spanLength(span),
                     directionIn(problem, cell, curve.at(tau))}
                );
            }
        },
        [](int, const PolynomialCurve&, const ShellCell&, const ShellCell&, double, int) {}
    );
    if (spans != space.spanCount()) {
        return std::nullopt;
    }
    return result;
}

std::optional<BendingDirections> directionsAtSamples(
    const CurveProblem& problem,
    const SplineSpace& space,
    const ControlPoints& controls,
    const SampleRule& rule
) {
    BendingDirections result;
    const auto visit = [&](const SampleWalker& walker,
                           const PolynomialCurve& /*curve*/,
                           int span,
                           double tau,
                           double weight) {
        if (walker.outside()) {
            return false;
        }
        result.samples.push_back(
            {space.breaks()[span] + tau * space.spanLength(span),
             weight,
             directionIn(problem, walker.cell(), walker.position())}
        );
        return true;
    };
    const bool isInside = walkSamples(problem, space, controls, rule, visit);
    return isInside ? std::optional(std::move(result)) : std::nullopt;
}

}  // namespace

Vec3 BendingDirections::at(double parameter) const {
    const auto above = std::upper_bound(
        samples.begin(), samples.end(), parameter, [](double value, const Sample& sample) {
            return value < sample.parameter;
        }
    );
    if (above == samples.begin() || above == samples.end()) {
        return above == samples.end() ? samples.back().direction : samples.front().direction;
    }
    const Sample& before = *(above - 1);
    const double gap = above->parameter - before.parameter;
    const double s = gap > 0.0 ? (parameter - before.parameter) / gap : 0.0;
    return ((1.0 - s) * before.direction + s * above->direction).normalized();
}

std::optional<BendingDirections> bendingDirectionsAlong(
    const CurveProblem& problem,
    const SplineSpace& space,
    const ControlPoints& controls,
    const SampleRule& rule
) {
    return rule.isExact() ? directionsInCells(problem, space, controls)
                          : directionsAtSamples(problem, space, controls, rule);
}

SplineSpace::BasisMatrix ambientProducts(
    const CurveProblem& problem, const SplineSpace& space, int span
) {
    const double tension = problem.options.tension;
    const double scale = 2.0 / (problem.chordLength * problem.chordLength);
    // Each derivative by t divides by the length, the integral multiplies by it.
    const double length = space.spanLength(span);
    const double stretch = scale * tension / length;
    const double bend = scale * (1.0 - tension) / (length * length * length);
    static const SplineSpace::BasisMatrix seconds = powerProducts(2);
    static const SplineSpace::BasisMatrix firsts = powerProducts(1);
    const SplineSpace::BasisMatrix& basis = space.basis(span);
    return basis * (bend * seconds + stretch * firsts) * basis.transpose();
}

InternalEnergy::InternalEnergy(
    const CurveProblem& problem, const SplineSpace& space, const SampleRule& rule
)
    : problem_(problem), space_(space) {
    const int n = space.basisCount();
    const std::vector<SplineSpace::BasisMatrix> products =
        variantOf(problem).bendingProducts(problem, space, rule);
    ambient_.assign(space.spanCount(), SpanMatrix::Zero(3 * n, 3 * n));
    for (int span = 0; span < space.spanCount(); ++span) {
        for (int j1 = 0; j1 < n; ++j1) {
            for (int j2 = 0; j2 < n; ++j2) {
                for (int axis = 0; axis < 3; ++axis) {
                    ambient_[span](3 * j1 + axis, 3 * j2 + axis) = products[span](j1, j2);
                }
            }
        }
    }
    internal_ = ambient_;
}

void InternalEnergy::setDirections(const BendingDirections& directions) {
    internal_ = ambient_;
    const double scale = -2.0 / (problem_.chordLength * problem_.chordLength) *
                         (1.0 - problem_.options.tension) *
                         (1.0 - problem_.options.normalBendingWeight);
    const auto addTo = [&](int span, SpanMoments& moments) {
        SpanBlocks blocks{};
        moments.addMatricesTo(blocks, space_.bernsteinBasis(span, 2), space_.basisCount());
        internal_[span] += dense(blocks, space_.basisCount());
        moments.clear();
    };
    int span = 0;
    SpanMoments moments(space_.degree() - 2);
    for (const BendingDirections::Sample& sample : directions.samples) {
        while (span + 1 < space_.spanCount() && sample.parameter > space_.breaks()[span + 1]) {
            addTo(span, moments);
            ++span;
        }
        const double tau = (sample.parameter - space_.breaks()[span]) / space_.spanLength(span);
        moments.addMatrix(tau, rankOne(sample.direction, scale * sample.weight));
    }
    addTo(span, moments);
}

double InternalEnergy::add(const ControlPoints& controls, EnergyDerivatives* derivatives) const {
    const int n = space_.basisCount();
    double energy = 0.0;
    SpanVector x(3 * n);
    SpanVector hx(3 * n);
    for (int span = 0; span < space_.spanCount(); ++span) {
        for (int j = 0; j < n; ++j) {
            x.segment<3>(3 * j) = controls.row(space_.control(span, j)).transpose();
        }
        hx.noalias() = internal_[span] * x;
        energy += 0.5 * x.dot(hx);
        if (derivatives != nullptr) {
            for (int j = 0; j < n; ++j) {
                derivatives->gradient.segment<3>(3 * space_.control(span, j)) +=
                    hx.segment<3>(3 * j);
            }
            for (int j = 0; j < n; ++j) {
                for (int k = 0; k <= j; ++k) {
                    // Of the lower triangle of the whole Hessian, where a closed spline wraps
                    // round.
                    const bool wraps = space_.control(span, j) < space_.control(span, k);
                    const auto m =
                        internal_[span].block<3, 3>(3 * (wraps ? k : j), 3 * (wraps ? j : k));
                    derivatives->hessian[span][blockIndex(j, k)] +=
                        SymmetricMatrix{m(0, 0), m(1, 0), m(2, 0), m(1, 1), m(2, 1), m(2, 2)};
                }
            }
        }
    }
    return energy;
}

}  // namespace bspline_curve
