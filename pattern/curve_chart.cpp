// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/curve_chart.h"

#include "bspline_curve/curve.h"
#include "bspline_curve/error.h"
#include "offset/surface_fan.h"
#include "pattern/straightest_path.h"
#include "surface/surface_point.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bspline_curve {

namespace {

constexpr double kPi = std::numbers::pi;
/// Ends of an open curve reach this far beyond it, relative to its length: rounding.
constexpr double kEndRelative = 1e-9;

/// The point between two of one face.
SurfacePoint between(
    const Surface& surface, const SurfacePoint& from, const SurfacePoint& to, double share
) {
    const int face = commonFace(surface, from, to);
    const SurfacePoint point{
        .face = face,
        .barycentric = (1.0 - share) * inFace(surface, from, face).barycentric +
                       share * inFace(surface, to, face).barycentric
    };
    return snapped(point, kOnEdgeBarycentric);
}

}  // namespace

CurveChart::CurveChart(const Surface& surface, const SurfacePolyline& line, double smoothing)
    : surface_(surface), closed_(line.closed), smoothing_(smoothing) {
    Vec3 last = Vec3::Zero();
    const auto add = [&](const SurfacePoint& point) {
        const Vec3 position = surface.position(point);
        if (points_.empty() || position != last) {
            starts_.push_back(points_.empty() ? 0.0 : starts_.back() + (position - last).norm());
            points_.push_back(snapped(point, kOnEdgeBarycentric));
            last = position;
        }
    };
    for (const SurfacePoint& point : line.surfacePoints) {
        add(point);
    }
    if (closed_ && !points_.empty()) {
        add(SurfacePoint(points_.front()));
    }
    if (points_.size() < (closed_ ? 3U : 2U)) {
        throw InputError(InputErrorCode::NoPath, "the curve has no length; draw another one");
    }
    double turn = 0.0;
    double integral = 0.0;
    for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
        turn += i > 0 ? turnAt(i) : 0.0;
        turns_.push_back(turn);
        integrals_.push_back(integral);
        integral += turn * (starts_[i + 1] - starts_[i]);
    }
    integrals_.push_back(integral);
    wholeTurn_ = closed_ ? turn + turnAt(0) : 0.0;
}

/// How far the curve turns to the left in a vertex.
double CurveChart::turnAt(std::size_t vertex) const {
    const SurfacePoint& here = points_[vertex];
    const SurfacePoint& before = points_[vertex > 0 ? vertex - 1 : points_.size() - 2];
    const SurfaceFan fan = fanOf(surface_, here);
    double left = angleTowards(surface_, fan, here, before) -
                  angleTowards(surface_, fan, here, points_[vertex + 1]);
    if (fan.closed) {
        left += left < 0.0 ? fan.angle : 0.0;
        return 0.5 * fan.angle - left;
    }
    return left > 0.0 ? kPi - left : -kPi - left;
}

std::size_t CurveChart::segmentAt(double along) const {
    const auto after = std::ranges::upper_bound(starts_, along);
    const auto index =
        static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - starts_.begin(), 1));
    return std::min(index - 1, turns_.size() - 1);
}

/// The integral of the direction over the length, from 0 on; round a closed curve again and again.
double CurveChart::turnIntegral(double along) const {
    const double rounds = closed_ ? std::floor(along / length()) : 0.0;
    const double rest = along - rounds * length();
    const std::size_t i = segmentAt(rest);
    const double within = integrals_[i] + turns_[i] * (rest - starts_[i]);
    return rounds * integrals_.back() + 0.5 * rounds * (rounds - 1.0) * wholeTurn_ * length() +
           rounds * wholeTurn_ * rest + within;
}

/// The mean direction near a place, less that of the segment there.
double CurveChart::meanTurn(double along) const {
    double reach = smoothing_;
    if (!closed_) {
        reach = std::min({reach, along, length() - along});
    }
    if (!(reach > kEndRelative * length())) {
        return 0.0;
    }
    return (turnIntegral(along + reach) - turnIntegral(along - reach)) / (2.0 * reach) -
           turns_[segmentAt(along)];
}

CarriedPoint CurveChart::at(const Eigen::Vector2d& point) const {
    double along = point.x();
    if (closed_) {
        along -= length() * std::floor(along / length());
    } else if (along < -kEndRelative * length() || along > (1.0 + kEndRelative) * length()) {
        return {.status = CarriedPoint::Status::BeyondCurve, .point = {}};
    }
    along = std::clamp(along, 0.0, length());
    const std::size_t i = segmentAt(along);
    const double share = (along - starts_[i]) / (starts_[i + 1] - starts_[i]);
    const SurfacePoint start = between(surface_, points_[i], points_[i + 1], share);
    if (point.y() == 0.0) {
        return {.point = start};
    }
    const SurfaceFan fan = fanOf(surface_, start);
    // Ends of the segment have no angle towards themselves.
    const bool isLater = share > 0.5;
    const SurfacePoint& seen = points_[isLater ? i : i + 1];
    const double halfTurn = fan.closed ? 0.5 * fan.angle : kPi;
    const double ahead = angleTowards(surface_, fan, start, seen) + (isLater ? halfTurn : 0.0);
    const double scale = fan.closed ? fan.angle / (2 * kPi) : 1.0;
    const double side = point.y() > 0.0 ? kPi / 2 : -kPi / 2;
    const StraightestPath path = straightestPath(
        surface_, start, fan, ahead + scale * (meanTurn(along) + side), std::abs(point.y())
    );
    if (!path.isWhole) {
        return {.status = CarriedPoint::Status::BeyondBoundary, .point = {}};
    }
    return {.point = path.points.back()};
}

}  // namespace bspline_curve
