// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/initial_curve.h"

#include "shell/polynomial_trace.h"
#include "solver/obstacles.h"
#include "solver/shell_reach.h"
#include "solver/solve_variant.h"
#include "solver/spline_fit.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace bspline_curve {
namespace {

// Next to a sharp corner of the initial path spans are halved one by one; more than 16 fits were
// needed once in 350 curves.
constexpr int kMaxFits = 40;
// Where there is no shell, spans are halved without end, each in two. So many breaks, and as many
// for each of the first.
constexpr std::size_t kMostBreaks = 1000, kMostBreaksEach = 50;
// A first curve that comes nearer to the top or the bottom than this is fitted again with more
// spans: close to the pole of the barrier, Newton's method stalls at once.
constexpr double kHighestStart = 0.9;
// The same where it comes nearer to what it avoids than this share of the initial path's least
// clearance.
constexpr double kLeastClearanceShare = 0.3;

// A pick with a tangent is two constraints, for which spans beside it are parted in four.
std::vector<double> quarteredAtTangents(
    const CurveProblem& problem, const std::vector<double>& breaks
) {
    constexpr int kParts = 4;
    const std::vector<PickConstraint>& picks = problem.picks;
    std::vector<double> finer{breaks.front()};
    for (std::size_t i = 1; i < breaks.size(); ++i) {
        if (picks[i - 1].hasTangent() || picks[i % picks.size()].hasTangent()) {
            for (int k = 1; k < kParts; ++k) {
                finer.push_back(
                    std::lerp(breaks[i - 1], breaks[i], static_cast<double>(k) / kParts)
                );
            }
        }
        finer.push_back(breaks[i]);
    }
    return finer;
}

std::vector<double> firstBreaks(const CurveProblem& problem) {
    std::vector<double> breaks;
    for (const PickConstraint& pick : problem.picks) {
        breaks.push_back(pick.parameter);
    }
    if (problem.options.closed) {
        breaks.push_back(1.0);
    }
    breaks = quarteredAtTangents(problem, breaks);
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

std::vector<SpanTarget> targetsOf(const InitialPath& initialPath, const SplineSpace& space) {
    std::vector<SpanTarget> targets;
    for (int span = 0; span < space.spanCount(); ++span) {
        targets.emplace_back(initialPath, space.breaks()[span], space.breaks()[span + 1]);
    }
    return targets;
}

// How clear of what it avoids the first curve must stay between two parameters.
double neededClearance(
    const CurveProblem& problem, const InitialPath& initialPath, double begin, double end
) {
    double least = 1.0;
    if (problem.obstacles != nullptr) {
        for (std::size_t i = initialPath.indexAt(begin); i <= initialPath.indexAt(end) + 1; ++i) {
            least =
                std::min(least, 1.0 - problem.obstacles->closeness(initialPath.points[i].point));
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
// from the initial path's own cell.
bool spanIsInside(
    const CurveProblem& problem,
    const InitialPath& initialPath,
    const SplineSpace& space,
    const ControlPoints& controls,
    double highestStart,
    int span
) {
    const PolynomialCurve curve = space.polynomial(controls, span);
    const InitialPath::Point& near = initialPath.points[initialPath.indexAt(space.breaks()[span])];
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
                        problem, initialPath, space.breaks()[span], space.breaks()[span + 1]
                    );
}

}  // namespace

std::size_t InitialPath::indexAt(double t) const {
    const auto above = std::ranges::upper_bound(points, t, {}, &Point::parameter);
    const auto index =
        static_cast<std::size_t>(std::max<std::ptrdiff_t>(1, above - points.begin())) - 1;
    return std::min(index, points.size() - 2);
}

std::size_t InitialPath::indexFrom(std::size_t earlier, double t) const {
    std::size_t index = earlier;
    while (index + 2 < points.size() && points[index + 1].parameter <= t) {
        ++index;
    }
    return index;
}

double InitialPath::length() const {
    double length = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        length += (points[i].position - points[i - 1].position).norm();
    }
    return length;
}

Vec3 InitialPath::positionAfter(std::size_t i, double t) const {
    const Point& a = points[i];
    const Point& b = points[i + 1];
    const double s =
        b.parameter > a.parameter ? (t - a.parameter) / (b.parameter - a.parameter) : 0.0;
    return (1.0 - s) * a.position + s * b.position;
}

std::optional<SplineCurve> makeFirstCurve(
    const CurveProblem& problem, const InitialPath& initialPath
) {
    return variantOf(problem).firstCurve(problem, initialPath);
}

SplineCurve fitLoosely(
    const CurveProblem& problem,
    const InitialPath& initialPath,
    double distance,
    std::vector<double> breaks
) {
    if (breaks.empty()) {
        breaks = firstBreaks(problem);
    }
    SplineSpace space(problem.options.degree, problem.options.closed, breaks);
    std::vector<SpanTarget> targets = targetsOf(initialPath, space);
    while (true) {
        ControlPoints controls = fitSpline(problem, space, targets);
        std::vector<double> finer{breaks.front()};
        std::vector<SpanTarget> finerTargets;
        for (int span = 0; span < space.spanCount(); ++span) {
            const PolynomialCurve curve = space.polynomial(controls, span);
            const double begin = breaks[span];
            const double end = breaks[span + 1];
            bool isFar = false;
            for (int i = 0; i < SpanTarget::kSamples && !isFar; ++i) {
                isFar =
                    (curve.at(SpanTarget::tau(i)) - targets[span].positions[i]).norm() > distance;
            }
            if (isFar && 0.5 * space.spanLength(span) >= problem.options.minimumSpan) {
                const double middle = 0.5 * (begin + end);
                finer.push_back(middle);
                finerTargets.emplace_back(initialPath, begin, middle);
                finerTargets.emplace_back(initialPath, middle, end);
            } else {
                finerTargets.push_back(targets[span]);
            }
            finer.push_back(end);
        }
        if (finer.size() == breaks.size()) {
            return {std::move(space), std::move(controls)};
        }
        breaks.swap(finer);
        targets.swap(finerTargets);
        space = SplineSpace(problem.options.degree, problem.options.closed, breaks);
    }
}

std::optional<SplineCurve> fitInitialPath(
    const CurveProblem& problem, const InitialPath& initialPath
) {
    std::vector<double> breaks = firstBreaks(problem);
    const double highestStart = kHighestStart / relativeReach(problem);
    const std::size_t mostBreaks = kMostBreaks + kMostBreaksEach * breaks.size();
    for (int attempt = 0; attempt < kMaxFits && breaks.size() <= mostBreaks; ++attempt) {
        SplineSpace space(problem.options.degree, problem.options.closed, breaks);
        ControlPoints controls = fitSpline(problem, space, targetsOf(initialPath, space));
        std::vector<double> finer{breaks.front()};
        for (int span = 0; span < space.spanCount(); ++span) {
            if (!spanIsInside(problem, initialPath, space, controls, highestStart, span)) {
                finer.push_back(0.5 * (breaks[span] + breaks[span + 1]));
            }
            finer.push_back(breaks[span + 1]);
        }
        if (finer.size() == breaks.size()) {
            return SplineCurve{std::move(space), std::move(controls)};
        }
        breaks.swap(finer);
    }
    return std::nullopt;
}

}  // namespace bspline_curve
