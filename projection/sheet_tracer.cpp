// SPDX-License-Identifier: GPL-3.0-or-later
#include "projection/sheet_tracer.h"

#include "surface/closest_point.h"
#include "surface/geodesic_path.h"
#include "surface/surface_point.h"
#include "utility/infinity.h"
#include "utility/sparse_map.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace bspline_curve {
namespace {

struct Constants {
    int leastFeet = 4, mostFeet = 256;  // of a span
    std::size_t mostFaces = 500;        // that are looked at for a foot
};

constexpr Constants kConstants;

/// The vertices that a point is between, ascending; -1 where they are less than three.
Triangle cornersBehind(const Surface& surface, const SurfacePoint& point) {
    Triangle corners = surface.faces()[point.face];
    for (int k = 0; k < 3; ++k) {
        if (point.barycentric[k] <= kOnEdgeBarycentric) {
            corners[k] = -1;
        }
    }
    std::ranges::sort(corners);
    return corners;
}

class SheetTracer {
public:
    SheetTracer(
        const SheetTraceStart& traced, const SplineSpace& space, const ControlPoints& controls
    )
        : traced_(traced),
          surface_(traced.surface),
          space_(space),
          controls_(controls),
          reach_(traced.tolerance * traced.extended.frame.scale) {
        distance_.perSpan.assign(space.spanCount(), 0.0);
    }

    // By feet of the spline.
    CurveDistance follow() {
        GeodesicPathFinder ways(surface_, {});
        const std::vector<double> parameters = feetParameters();
        std::size_t nextPick = 1;
        trace_.points.push_back({0.0, traced_.picks.front().point});
        measure(trace_.points.back());
        for (const double t : parameters) {
            EdgeCrossing foot{t, {}};
            if (nextPick < traced_.picks.size() && traced_.picks[nextPick].parameter == t) {
                foot.point = traced_.picks[nextPick++].point;
            } else if (space_.closed() && t == 1.0) {
                foot.point = traced_.picks.front().point;
            } else {
                foot.point = nearestFrom(startOf(t), user(at(t)));
            }
            if (distance_.largest > traced_.mostDistance || !join(ways, foot)) {
                distance_.largest = kInfinity;
                return std::move(distance_);
            }
        }
        return finished();
    }

    // By the guide.
    CurveDistance followGuide() {
        for (const EdgeCrossing& point : traced_.guide) {
            if (trace_.points.empty()) {
                trace_.points.push_back(point);
                measure(point);
            } else {
                append(point);
            }
        }
        return finished();
    }

private:
    [[nodiscard]] Vec3 at(double t) const {
        const int span = space_.spanAt(t);
        const double tau = (t - space_.breaks()[span]) / space_.spanLength(span);
        return space_.polynomial(controls_, span).at(tau);
    }

    [[nodiscard]] Vec3 user(const Vec3& unit) const { return traced_.extended.frame.toUser(unit); }

    // All but 0: breaks, picks, and between them so many that steps are short.
    [[nodiscard]] std::vector<double> feetParameters() const {
        std::vector<double> parameters;
        for (int span = 0; span < space_.spanCount(); ++span) {
            const PolynomialCurve curve = space_.polynomial(controls_, span);
            const double length =
                (curve.at(0.5) - curve.at(0.0)).norm() + (curve.at(1.0) - curve.at(0.5)).norm();
            const double needed = std::ceil(length / traced_.stepLength);
            const int count = static_cast<int>(std::clamp(
                needed,
                static_cast<double>(kConstants.leastFeet),
                static_cast<double>(kConstants.mostFeet)
            ));
            for (int i = 1; i < count; ++i) {
                parameters.push_back(space_.breaks()[span] + space_.spanLength(span) * i / count);
            }
            parameters.push_back(space_.breaks()[span + 1]);
        }
        for (const PickConstraint& pick : traced_.picks.subspan(1)) {
            parameters.push_back(pick.parameter);
        }
        std::ranges::sort(parameters);
        const auto rest = std::ranges::unique(parameters);
        parameters.erase(rest.begin(), rest.end());
        return parameters;
    }

    [[nodiscard]] SurfacePoint startOf(double t) const {
        if (traced_.guide.empty()) {
            return trace_.points.back().point;
        }
        const auto after = std::ranges::upper_bound(traced_.guide, t, {}, &EdgeCrossing::parameter);
        return after == traced_.guide.begin() ? after->point : (after - 1)->point;
    }

    // The nearest point of those that are joined to a start without leaving the ball around p that
    // holds the start, and is as much larger as the tolerance: over the rim of a thin part as well,
    // where p is near to it.
    [[nodiscard]] SurfacePoint nearestFrom(const SurfacePoint& start, const Vec3& p) {
        const double reach = std::sqrt((surface_.position(start) - p).squaredNorm()) + reach_;
        const double squaredReach = reach * reach;
        SurfacePoint best = start;
        double squared = kInfinity;
        seen_.clear();
        queue_ = {start.face};
        seen_.at(start.face, 1);
        for (std::size_t i = 0; i < queue_.size() && i < kConstants.mostFaces; ++i) {
            const int face = queue_[i];
            const ClosestPointOnTriangle closest =
                closestPointOnTriangle(surface_.vertices(), surface_.faces()[face], p);
            if (closest.squaredDistance > squaredReach) {
                continue;
            }
            if (closest.squaredDistance < squared) {
                squared = closest.squaredDistance;
                best = snapped({face, closest.barycentric}, kSnapBarycentric);
            }
            for (const int next : surface_.faceNeighbours()[face]) {
                if (next >= 0 && seen_.find(next) == nullptr) {
                    seen_.at(next, 1);
                    queue_.push_back(next);
                }
            }
        }
        return best;
    }

    // On to a foot by the shortest way on the surface. False where there is none.
    [[nodiscard]] bool join(GeodesicPathFinder& ways, const EdgeCrossing& foot) {
        const EdgeCrossing from = trace_.points.back();
        if (commonFace(surface_, from.point, foot.point) >= 0) {
            append(foot);
            return true;
        }
        const std::optional<GeodesicPath> way = ways.find(from.point, foot.point);
        if (!way) {
            return false;
        }
        double passed = 0.0;
        for (std::size_t i = 1; i + 1 < way->points.size(); ++i) {
            passed += (way->positions[i] - way->positions[i - 1]).norm();
            const double share = way->length > 0.0 ? std::min(1.0, passed / way->length) : 0.0;
            append({std::lerp(from.parameter, foot.parameter, share), way->points[i]});
        }
        append(foot);
        return true;
    }

    void append(const EdgeCrossing& point) {
        const int face = commonFace(surface_, trace_.points.back().point, point.point);
        trace_.pieces.push_back({point.parameter, space_.spanAt(point.parameter), face});
        trace_.points.push_back(point);
        measure(point);
    }

    void measure(const EdgeCrossing& point) {
        const double distance =
            (at(point.parameter) - traced_.extended.frame.toUnit(surface_.position(point.point)))
                .norm();
        double& ofSpan = distance_.perSpan[space_.spanAt(point.parameter)];
        ofSpan = std::max(ofSpan, distance);
        distance_.largest = std::max(distance_.largest, distance);
    }

    // Whether a point of the trace is the pick at its parameter, if there is one. Where coordinates
    // are large, a crossing beside the pick may have the same position and so the same parameter.
    [[nodiscard]] bool isPick(const EdgeCrossing& point) const {
        const auto isThere = [&](const PickConstraint& pick) {
            return cornersBehind(surface_, pick.point) == cornersBehind(surface_, point.point);
        };
        if (space_.closed() && point.parameter == 1.0) {
            return isThere(traced_.picks.front());
        }
        return std::ranges::any_of(traced_.picks, [&](const PickConstraint& pick) {
            return pick.parameter == point.parameter && isThere(pick);
        });
    }

    CurveDistance finished() {
        trace_.isWhole = true;
        trace_.wholeSpans = space_.spanCount();
        std::size_t arrivals = 0;  // the last crossings, with one parameter
        for (const EdgeCrossing& point : trace_.points) {
            std::vector<EdgeCrossing>& crossings = trace_.crossings;
            if (crossings.empty() || crossings.back().parameter != point.parameter) {
                arrivals = crossings.size();
            }
            if (!isPick(point)) {
                crossings.push_back(point);
                continue;
            }
            // What comes before the pick must stay before it.
            for (; arrivals < crossings.size(); ++arrivals) {
                crossings[arrivals].parameter = std::nextafter(point.parameter, 0.0);
            }
        }
        distance_.trace = std::move(trace_);
        return std::move(distance_);
    }

    const SheetTraceStart& traced_;
    const Surface& surface_;
    const SplineSpace& space_;
    const ControlPoints& controls_;
    double reach_;            // in the user's unit
    SparseMap<char> seen_;    // of nearestFrom()
    std::vector<int> queue_;  // likewise
    SheetTrace trace_;
    CurveDistance distance_;
};

}  // namespace

CurveDistance measureOnSheet(
    const SheetTraceStart& traced, const SplineSpace& space, const ControlPoints& controls
) {
    return SheetTracer(traced, space, controls).follow();
}

CurveDistance measureOnPath(
    const SheetTraceStart& traced, const SplineSpace& space, const ControlPoints& controls
) {
    return SheetTracer(traced, space, controls).followGuide();
}

}  // namespace bspline_curve
