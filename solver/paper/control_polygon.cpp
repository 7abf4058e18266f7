// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/paper/control_polygon.h"

#include "projection/curve_distance.h"
#include "shell/polynomial_trace.h"
#include "solver/problem_traces.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace bspline_curve {
namespace {

// Intervals of the way shorter than this are not halved any more: the polygon may then leave the
// shell, which the sampled energy can bear.
constexpr double kShortestInterval = 1e-3;
// How near to top and bottom the control points lie: on them, rounding would decide the side.
constexpr double kControlHeight = 0.98;

struct ControlVertex {
    double parameter;  // along the initial path
    SurfacePoint point;
    Vec3 position;
};

SurfacePoint pathPoint(const InitialPath& initialPath, double t) {
    const auto above = std::lower_bound(
        initialPath.points.begin(),
        initialPath.points.end(),
        t,
        [](const InitialPath::Point& p, double value) { return p.parameter < value; }
    );
    // The nearer of the initial path's own points: Mid() of Alg. 2 is a vertex of the path as well.
    if (above == initialPath.points.begin()) {
        return above->point;
    }
    if (above == initialPath.points.end()) {
        return initialPath.points.back().point;
    }
    return t - (above - 1)->parameter < above->parameter - t ? (above - 1)->point : above->point;
}

class PolygonMaker {
public:
    // No interval of the way between two control points is longer than `longest`.
    PolygonMaker(const CurveProblem& problem, const InitialPath& initialPath, double longest)
        : problem_(problem), path_(initialPath), longest_(longest) {}

    // Alg. 2: picks in turn to top and bottom; between two of them the middle of the way is added
    // until the segments stay in the shell.
    std::vector<ControlVertex> make() {
        const std::vector<PickConstraint>& picks = problem_.picks;
        polygon_.push_back({0.0, picks[0].point, picks[0].position});
        for (std::size_t i = 1; i < picks.size(); ++i) {
            const bool last = i + 1 == picks.size() && !problem_.options.closed;
            connect(picks[i].parameter, picks[i].point, last, picks[i].position);
        }
        if (problem_.options.closed) {
            connect(1.0, picks[0].point, true, picks[0].position);
            polygon_.pop_back();
        }
        return polygon_;
    }

private:
    void connect(
        double parameter, const SurfacePoint& point, bool onSurface, const Vec3& position
    ) {
        const ControlVertex from = polygon_.back();
        const ControlVertex to = {
            parameter, point, onSurface ? position : problem_.shell->lift(point, height())
        };
        const double interval = parameter - from.parameter;
        if (interval > longest_ || (interval > kShortestInterval && leavesShell(from, to))) {
            const double middle = 0.5 * (from.parameter + parameter);
            const SurfacePoint between = pathPoint(path_, middle);
            connect(middle, between, false, Vec3::Zero());
            connect(parameter, point, onSurface, position);
            return;
        }
        polygon_.push_back(to);
        top_ = !top_;
    }

    [[nodiscard]] double height() const { return top_ ? kControlHeight : -kControlHeight; }

    [[nodiscard]] bool leavesShell(const ControlVertex& from, const ControlVertex& to) const {
        // From the surface up to the control point along its fibre, then along the segment.
        TraceState state{ShellCell(*problem_.shell, from.point)};
        const Vec3 onSurface = problem_.extended->position(from.point);
        return !walkStraight(*problem_.shell, onSurface, from.position, state) ||
               !walkStraight(*problem_.shell, from.position, to.position, state);
    }

    const CurveProblem& problem_;
    const InitialPath& path_;
    double longest_;
    std::vector<ControlVertex> polygon_;
    bool top_ = true;
};

// Breaks such that the averages of `degree` consecutive knots (the places where control points act)
// follow the parameters of the control points.
std::vector<double> averagedBreaks(
    const std::vector<ControlVertex>& polygon, int degree, bool closed
) {
    std::vector<double> breaks{0.0};
    const int n = static_cast<int>(polygon.size());
    const int inner = closed ? n - 1 : n - degree - 1;
    for (int i = 1; i <= inner; ++i) {
        double sum = 0.0;
        for (int j = 0; j < degree; ++j) {
            // Closed: centred on control point i; open: controls i .. i + degree - 1.
            const int c = closed ? i - degree / 2 + j : i + j;
            const int wrapped = (c % n + n) % n;
            const double turn = closed ? std::floor(static_cast<double>(c) / n) : 0.0;
            sum += polygon[wrapped].parameter + turn;
        }
        breaks.push_back(sum / degree);
    }
    breaks.push_back(1.0);
    return breaks;
}

SplineCurve splineOf(const CurveProblem& problem, const InitialPath& initialPath, double longest) {
    const int degree = problem.options.degree;
    const bool closed = problem.options.closed;
    std::vector<ControlVertex> polygon = PolygonMaker(problem, initialPath, longest).make();
    // Few picks in a thick shell: a spline needs degree + 1 control points.
    while (static_cast<int>(polygon.size()) < degree + 1 + (closed ? 1 : 0)) {
        std::vector<ControlVertex> finer;
        const std::size_t segments = polygon.size() - (closed ? 0 : 1);
        for (std::size_t i = 0; i < segments; ++i) {
            const double end = i + 1 < polygon.size() ? polygon[i + 1].parameter : 1.0;
            const double middle = 0.5 * (polygon[i].parameter + end);
            const SurfacePoint point = pathPoint(initialPath, middle);
            finer.push_back(polygon[i]);
            finer.push_back({middle, point, problem.extended->position(point)});
        }
        if (!closed) {
            finer.push_back(polygon.back());
        }
        polygon.swap(finer);
    }
    SplineSpace space(degree, closed, averagedBreaks(polygon, degree, closed));
    ControlPoints controls(space.controlCount(), 3);
    for (int c = 0; c < space.controlCount(); ++c) {
        // Closed: basis function c acts around break c - (degree - 1) / 2.
        const int source =
            closed ? (c - (degree - 1) / 2 + space.controlCount()) % space.controlCount() : c;
        controls.row(c) = polygon[source].position.transpose();
    }
    return {std::move(space), std::move(controls)};
}

}  // namespace

SplineCurve makeControlPolygon(const CurveProblem& problem, const InitialPath& initialPath) {
    // A polygon inside the shell does not keep the curve inside, since a thin shell is not convex:
    // shorter segments do.
    double longest = 1.0;
    SplineCurve curve = splineOf(problem, initialPath, longest);
    while (!std::isfinite(
               measureDistance(traceStartOf(problem), curve.space, curve.controls).largest
           ) &&
           longest > kShortestInterval) {
        longest *= 0.5;
        curve = splineOf(problem, initialPath, longest);
    }
    return curve;
}

}  // namespace bspline_curve
