// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/paper/control_polygon.h"

#include "projection/curve_distance.h"
#include "shell/polynomial_trace.h"
#include "solver/paper/edge_path.h"
#include "solver/problem_traces.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace bspline_curve {
namespace {

// Parts of a way shorter than this, by the curve's parameter, are not halved any more: the polygon
// may then leave the shell, which the sampled energy can bear.
constexpr double kShortestInterval = 1e-3;
// How near to top and bottom the control points lie: on them, rounding would decide the side.
constexpr double kControlHeight = 0.98;
// Cell by cell a curve must begin inside the shell: its polygon is halved up to so many times.
constexpr int kMostHalvings = 8;

struct ControlVertex {
    double parameter;
    SurfacePoint point;
    Vec3 position;
};

class PolygonMaker {
public:
    explicit PolygonMaker(const CurveProblem& problem)
        : problem_(problem), isTop_(surfaceHeightAt(problem.picks[1].point) > 0.0) {}

    // Alg. 2: picks in turn to top and bottom, but for the first and, of an open curve, the last. A
    // closed one comes back to the first.
    std::vector<ControlVertex> make() {
        const std::vector<PickConstraint>& picks = problem_.picks;
        polygon_.push_back({0.0, picks[0].point, picks[0].position});
        for (std::size_t i = 1; i < picks.size(); ++i) {
            const bool isLast = i + 1 == picks.size() && !problem_.options.closed;
            connect(picks[i], picks[i].parameter, isLast);
        }
        if (problem_.options.closed) {
            connect(picks[0], 1.0, true);
            polygon_.pop_back();
        }
        return std::move(polygon_);
    }

private:
    // f of the surface: 0 in a shell of full resolution.
    [[nodiscard]] double surfaceHeightAt(const SurfacePoint& point) const {
        const ShellCell cell(*problem_.shell, point);
        return cell.surfaceHeight.at(problem_.extended->position(point));
    }

    // Lines 4 to 22: the pick on one side. While the segment to it leaves the shell, the middle of
    // what is left of the way comes between, on the other side.
    void connect(const PickConstraint& pick, double parameter, bool isOnSurface) {
        const ControlVertex before = polygon_.back();
        const ControlVertex to{
            parameter, pick.point, isOnSurface ? pick.position : lift(pick.point, isTop_)
        };
        std::optional<EdgePath> way;
        double walked = 0.0;
        while (leavesShell(polygon_.back(), to) &&
               parameter - polygon_.back().parameter > kShortestInterval) {
            if (!way) {
                way = EdgePath::shortest(problem_, before.point, pick.point);
            }
            if (!way) {
                break;
            }
            walked = 0.5 * (walked + way->length());
            const double share = way->length() > 0.0 ? walked / way->length() : 1.0;
            const SurfacePoint middle = way->at(walked);
            polygon_.push_back(
                {before.parameter + share * (parameter - before.parameter),
                 middle,
                 lift(middle, !isTop_)}
            );
        }
        polygon_.push_back(to);
        isTop_ = !isTop_;
    }

    [[nodiscard]] Vec3 lift(const SurfacePoint& point, bool isTop) const {
        return problem_.shell->lift(point, isTop ? kControlHeight : -kControlHeight);
    }

    [[nodiscard]] bool leavesShell(const ControlVertex& from, const ControlVertex& to) const {
        // From the surface up to the control point along its fibre, then along the segment.
        TraceState state{ShellCell(*problem_.shell, from.point)};
        const Vec3 onSurface = problem_.extended->position(from.point);
        return !walkStraight(*problem_.shell, onSurface, from.position, state) ||
               !walkStraight(*problem_.shell, from.position, to.position, state);
    }

    const CurveProblem& problem_;
    std::vector<ControlVertex> polygon_;
    bool isTop_;
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

// A spline needs degree + 1 control points, a closed one one more: the middles of the ways between
// the picks come between, on the surface.
std::vector<ControlVertex> withMiddles(
    const CurveProblem& problem, const std::vector<ControlVertex>& polygon
) {
    std::vector<ControlVertex> finer;
    const std::size_t segments = polygon.size() - (problem.options.closed ? 0 : 1);
    for (std::size_t i = 0; i < segments; ++i) {
        const ControlVertex& from = polygon[i];
        const ControlVertex& to = polygon[(i + 1) % polygon.size()];
        const double end = i + 1 < polygon.size() ? to.parameter : 1.0;
        finer.push_back(from);
        if (const std::optional<EdgePath> way = EdgePath::shortest(problem, from.point, to.point)) {
            const SurfacePoint middle = way->at(0.5 * way->length());
            finer.push_back(
                {0.5 * (from.parameter + end), middle, problem.extended->position(middle)}
            );
        }
    }
    if (!problem.options.closed) {
        finer.push_back(polygon.back());
    }
    return finer;
}

SplineCurve splineOf(const CurveProblem& problem, const std::vector<ControlVertex>& polygon) {
    const int degree = problem.options.degree;
    const bool closed = problem.options.closed;
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

// A polygon inside the shell does not keep the curve inside, since a thin shell is not convex.
bool isOutside(const CurveProblem& problem, const SplineCurve& curve) {
    return !std::isfinite(
        measureDistance(traceStartOf(problem), curve.space, curve.controls).largest
    );
}

}  // namespace

std::optional<SplineCurve> makeControlPolygon(const CurveProblem& problem) {
    std::vector<ControlVertex> polygon = PolygonMaker(problem).make();
    const std::size_t needed =
        static_cast<std::size_t>(problem.options.degree) + (problem.options.closed ? 2 : 1);
    while (polygon.size() < needed) {
        std::vector<ControlVertex> finer = withMiddles(problem, polygon);
        if (finer.size() == polygon.size()) {
            return std::nullopt;
        }
        polygon.swap(finer);
    }
    SplineCurve curve = splineOf(problem, polygon);
    if (problem.options.quadrature != Quadrature::Samples) {
        for (int i = 0; i < kMostHalvings && isOutside(problem, curve); ++i) {
            polygon = withMiddles(problem, polygon);
            curve = splineOf(problem, polygon);
        }
    }
    return curve;
}

}  // namespace bspline_curve
