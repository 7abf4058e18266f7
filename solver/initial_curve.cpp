// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/initial_curve.h"

#include "solver/obstacles.h"
#include "solver/shell_reach.h"
#include "solver/spline_system.h"

#include <algorithm>
#include <cmath>

namespace bspline_curve {
namespace {

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

// Next to a sharp corner of the guide spans are halved one by one; more than 16 fits were needed
// once in 350 curves.
constexpr int kMaxFits = 40;
// A first curve that comes nearer to the top or the bottom than this is fitted again with more
// spans: close to the pole of the barrier, Newton's method stalls at once.
constexpr double kHighestStart = 0.9;
// The same where it comes nearer to what it avoids than this share of the guide's least clearance.
constexpr double kLeastClearanceShare = 0.3;
// Samples of the guide per span: more than the unknowns of a span, few enough to be cheap.
constexpr int kSamplesPerSpan = 16;
// Weight of the bending regulariser against the squared distance, in units of the span length to
// the fourth.
constexpr double kRegularisation = 1e-5;

// The last guide point at or before t.
std::size_t guideIndex(const GuidePath& guide, double t) {
    const auto above = std::upper_bound(
        guide.points.begin(), guide.points.end(), t, [](double value, const GuidePath::Point& p) {
            return value < p.parameter;
        }
    );
    const auto index =
        static_cast<std::size_t>(std::max<std::ptrdiff_t>(1, above - guide.points.begin())) - 1;
    return std::min(index, guide.points.size() - 2);
}

Vec3 guidePosition(const GuidePath& guide, double t) {
    const std::size_t i = guideIndex(guide, t);
    const GuidePath::Point& a = guide.points[i];
    const GuidePath::Point& b = guide.points[i + 1];
    const double s =
        b.parameter > a.parameter ? (t - a.parameter) / (b.parameter - a.parameter) : 0.0;
    return (1.0 - s) * a.position + s * b.position;
}

std::vector<double> firstBreaks(const CurveProblem& problem) {
    std::vector<double> breaks;
    for (const PickConstraint& pick : problem.picks) {
        breaks.push_back(pick.parameter);
    }
    if (problem.options.closed) {
        breaks.push_back(1.0);
    }
    const int needed = problem.options.degree + 1;  // of a closed spline
    while (static_cast<int>(breaks.size()) - 1 < needed) {
        std::vector<double> finer{breaks.front()};
        for (std::size_t i = 1; i < breaks.size(); ++i) {
            finer.push_back(0.5 * (breaks[i - 1] + breaks[i]));
            finer.push_back(breaks[i]);
        }
        breaks.swap(finer);
    }
    return breaks;
}

ControlPoints fit(const CurveProblem& problem, const GuidePath& guide, const SplineSpace& space) {
    const int n = space.basisCount();
    SplineSystem system(space, interpolationRows(space, problem.picks));
    std::vector<SpanMatrix> blocks(at(space.spanCount()), SpanMatrix::Zero(3 * n, 3 * n));
    Eigen::VectorXd gradient =
        Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(space.controlCount()));
    for (int span = 0; span < space.spanCount(); ++span) {
        const double length = space.spanLength(span);
        for (int i = 0; i < kSamplesPerSpan; ++i) {
            const double tau = (i + 0.5) / kSamplesPerSpan;
            const double weight = length / kSamplesPerSpan;
            const Vec3 target = guidePosition(guide, space.breaks()[at(span)] + tau * length);
            const SplineSpace::BasisValues basis = space.basisAt(span, tau);
            const SplineSpace::BasisValues second = space.basisDerivativeAt(span, tau, 2);
            const double bending = kRegularisation * weight * length * length * length * length;
            for (int j1 = 0; j1 < n; ++j1) {
                for (int j2 = 0; j2 < n; ++j2) {
                    const double value = weight * basis[at(j1)] * basis[at(j2)] +
                                         bending * second[at(j1)] * second[at(j2)];
                    for (int axis = 0; axis < 3; ++axis) {
                        blocks[at(span)](3 * j1 + axis, 3 * j2 + axis) += value;
                    }
                }
                gradient.segment<3>(3 * space.control(span, j1)) -= weight * basis[at(j1)] * target;
            }
        }
    }
    ControlPoints controls = ControlPoints::Zero(space.controlCount(), 3);
    // One Newton step from zero solves the quadratic problem under the interpolation constraints.
    constexpr double kFitConstraintWeight = 1e4;
    if (system.factorise(blocks, kFitConstraintWeight)) {
        Eigen::Map<Eigen::VectorXd>(controls.data(), controls.size()) =
            system.constrainedStep(gradient, system.residual(controls), kFitConstraintWeight);
        // To rounding, before it is asked whether the curve stays inside.
        system.meetConstraints(controls);
    }
    return controls;
}

// How clear of what it avoids the first curve must stay between two parameters.
double neededClearance(
    const CurveProblem& problem, const GuidePath& guide, double begin, double end
) {
    double least = 1.0;
    if (problem.obstacles != nullptr) {
        for (std::size_t i = guideIndex(guide, begin); i <= guideIndex(guide, end) + 1; ++i) {
            least = std::min(least, 1.0 - problem.obstacles->closeness(guide.points[i].point));
        }
    }
    return kLeastClearanceShare * least;
}

double clearance(const CurveProblem& problem, const ShellCell& cell, const Vec3& p) {
    return problem.obstacles == nullptr
               ? 1.0
               : 1.0 - problem.obstacles->closeness({cell.face, cell.shadow(p)});
}

// Whether the curve stays well inside the shell, and clear of what it avoids, on a span, starting
// from the guide's own cell.
bool spanIsInside(
    const CurveProblem& problem,
    const GuidePath& guide,
    const SplineSpace& space,
    const ControlPoints& controls,
    double highestStart,
    int span
) {
    const PolynomialCurve curve = space.polynomial(controls, span);
    const GuidePath::Point& near = guide.points[guideIndex(guide, space.breaks()[at(span)])];
    TraceState state{ShellCell(*problem.shell, near.point)};
    double highest = 0.0;
    double least = 1.0;
    const auto measure = [&](const ShellCell& cell, double tau0, double tau1) {
        for (const double tau : {tau0, 0.5 * (tau0 + tau1), tau1}) {
            const Vec3 p = curve.at(tau);
            highest = std::max(highest, std::abs(cell.relativeHeight(p)));
            least = std::min(least, clearance(problem, cell, p));
        }
    };
    const auto ignoreCrossing = [](const ShellCell&, const ShellCell&, double, int) {};
    return walkStraight(*problem.shell, near.position, curve.coefficients[0], state) &&
           tracePolynomial(*problem.shell, curve, 1.0, state, measure, ignoreCrossing) &&
           highest < highestStart &&
           least >= neededClearance(
                        problem, guide, space.breaks()[at(span)], space.breaks()[at(span) + 1]
                    );
}

}  // namespace

std::optional<SplineCurve> makeFirstCurve(const CurveProblem& problem, const GuidePath& guide) {
    return problem.options.initialCurve == InitialCurve::GeodesicFit
               ? fitGuidePath(problem, guide)
               : makeControlPolygon(problem, guide);
}

SplineCurve fitLoosely(const CurveProblem& problem, const GuidePath& guide, double distance) {
    std::vector<double> breaks = firstBreaks(problem);
    while (true) {
        SplineSpace space(problem.options.degree, problem.options.closed, breaks);
        ControlPoints controls = fit(problem, guide, space);
        std::vector<double> finer{breaks.front()};
        for (int span = 0; span < space.spanCount(); ++span) {
            const PolynomialCurve curve = space.polynomial(controls, span);
            const bool isShort = 0.5 * space.spanLength(span) < problem.options.minimumSpan;
            for (int i = 0; i < kSamplesPerSpan && !isShort; ++i) {
                const double tau = (i + 0.5) / kSamplesPerSpan;
                const double t = breaks[at(span)] + tau * space.spanLength(span);
                if ((curve.at(tau) - guidePosition(guide, t)).norm() > distance) {
                    finer.push_back(0.5 * (breaks[at(span)] + breaks[at(span) + 1]));
                    break;
                }
            }
            finer.push_back(breaks[at(span) + 1]);
        }
        if (finer.size() == breaks.size()) {
            return {std::move(space), std::move(controls)};
        }
        breaks.swap(finer);
    }
}

std::optional<SplineCurve> fitGuidePath(const CurveProblem& problem, const GuidePath& guide) {
    std::vector<double> breaks = firstBreaks(problem);
    const double highestStart = kHighestStart / relativeReach(problem);
    for (int attempt = 0; attempt < kMaxFits; ++attempt) {
        SplineSpace space(problem.options.degree, problem.options.closed, breaks);
        ControlPoints controls = fit(problem, guide, space);
        std::vector<double> finer{breaks.front()};
        for (int span = 0; span < space.spanCount(); ++span) {
            if (!spanIsInside(problem, guide, space, controls, highestStart, span)) {
                finer.push_back(0.5 * (breaks[at(span)] + breaks[at(span) + 1]));
            }
            finer.push_back(breaks[at(span) + 1]);
        }
        if (finer.size() == breaks.size()) {
            return SplineCurve{std::move(space), std::move(controls)};
        }
        breaks.swap(finer);
    }
    return std::nullopt;
}

}  // namespace bspline_curve
