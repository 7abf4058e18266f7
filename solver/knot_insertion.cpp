// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/knot_insertion.h"

#include "projection/cell_tracer.h"
#include "solver/barrier.h"
#include "solver/cellwise_newton.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace bspline_curve {
namespace {

// Spans that together promise this share of the gain are halved at once: 0.7 costs twice the
// rounds, 1.0 more knots.
constexpr double kShareOfGain = 0.9;
// The barrier in the feature function is cut off here, below its pole.
constexpr double kHighest = 0.999;

bool canHalve(const SplineSpace& space, int span, double minimumSpan) {
    return 0.5 * space.spanLength(span) >= minimumSpan;
}

}  // namespace

std::vector<double> halveSpans(
    const SplineSpace& space, const std::vector<char>& marked, double minimumSpan
) {
    std::vector<double> breaks{space.breaks().front()};
    for (int span = 0; span < space.spanCount(); ++span) {
        if (marked[span] != 0 && canHalve(space, span, minimumSpan)) {
            breaks.push_back(0.5 * (space.breaks()[span] + space.breaks()[span + 1]));
        }
        breaks.push_back(space.breaks()[span + 1]);
    }
    return breaks;
}

KnotDemand predictGain(
    const CurveProblem& problem,
    const SplineSpace& space,
    const ControlPoints& controls,
    const EnergyWeights& weights,
    const BendingDirections& directions,
    int segments
) {
    KnotDemand gain;
    gain.perSpan.assign(space.spanCount(), 0.0);
    const SplineSpace fine(
        space.degree(),
        space.closed(),
        halveSpans(space, std::vector<char>(space.spanCount(), 1), 0.0)
    );
    const ControlPoints fineControls = refine(space, controls, fine);
    const std::vector<InterpolationRow> rows = interpolationRows(fine, problem.picks);
    CellwiseEnergy energy(problem, fine, rows, segments);
    SplineSystem system(fine, rows);
    EnergyDerivatives derivatives;
    if (problem.options.bending == Bending::Geodesic) {
        std::optional<BendingDirections> resampled =
            bendingDirectionsAlong(problem, fine, fineControls, segments);
        if (!resampled) {
            return gain;
        }
        for (BendingDirections::Sample& sample : resampled->samples) {
            sample.direction = directions.at(sample.parameter);
        }
        energy.setDirections(*resampled);
    }
    if (!energy.evaluate(fineControls, weights, derivatives).inside) {
        return gain;
    }
    // Negative kinks can make the finer Hessian nearly singular, and the promise without bound:
    // leave them out.
    for (SpanMatrix& block : derivatives.negativeKinks) {
        block.setZero();
    }
    const std::optional<NewtonStep> step =
        newtonStep(system, derivatives, problem.options.interpolation, fineControls);
    if (!step) {
        return gain;
    }
    gain.total = -0.5 * derivatives.gradient.dot(step->direction);
    for (int c = 0; c < fine.controlCount(); ++c) {
        gain.largestMove = std::max(
            gain.largestMove, step->direction.segment<3>(3 * static_cast<Eigen::Index>(c)).norm()
        );
    }
    // The fall is half the step's energy norm, which the spans share.
    SpanVector local(3 * fine.basisCount());
    for (int span = 0; span < fine.spanCount(); ++span) {
        for (int j = 0; j < fine.basisCount(); ++j) {
            local.segment<3>(3 * j) =
                step->direction.segment<3>(3 * static_cast<Eigen::Index>(fine.control(span, j)));
        }
        gain.perSpan[span / 2] += 0.5 * local.dot(derivatives.hessian[span] * local);
    }
    return gain;
}

std::vector<double> halveLargest(
    const SplineSpace& space, const KnotDemand& gain, double minimumSpan
) {
    std::vector<int> order;
    double sum = 0.0;
    for (int span = 0; span < space.spanCount(); ++span) {
        if (canHalve(space, span, minimumSpan) && gain.perSpan[span] > 0.0) {
            order.push_back(span);
            sum += gain.perSpan[span];
        }
    }
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
        return gain.perSpan[a] > gain.perSpan[b];
    });
    std::vector<char> marked(gain.perSpan.size(), 0);
    double reached = 0.0;
    for (const int span : order) {
        if (reached >= kShareOfGain * sum) {
            break;
        }
        reached += gain.perSpan[span];
        marked[span] = 1;
    }
    return halveSpans(space, marked, minimumSpan);
}

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
