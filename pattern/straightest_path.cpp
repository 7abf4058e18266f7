// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/straightest_path.h"

#include "offset/face_layout.h"
#include "surface/surface_point.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace bspline_curve {

namespace {

using Vec2 = Eigen::Vector2d;

constexpr double kTurn = 2 * std::numbers::pi;
/// Directions that are nearer to the boundary lead along it: an angle of rounding.
constexpr double kLeastAngle = 1e-12;
/// The sine of the angle between a direction and the normal, below which it has no direction on
/// the surface.
constexpr double kLeastSine = 1e-6;

FaceLayout layoutOf(const Surface& surface, int face) {
    return {surface.vertices(), surface.faces()[face], 0};
}

class Tracer {
public:
    Tracer(const Surface& surface, const SurfacePoint& start, double length)
        : surface_(surface), left_(length) {
        path_.points.push_back(start);
    }

    StraightestPath trace(const SurfaceFan& fan, double angle) {
        leave(fan, angle);
        while (isGoing_) {
            step();
        }
        return std::move(path_);
    }

private:
    /// Sets off from the fan's point.
    void leave(const SurfaceFan& fan, double angle) {
        if (fan.closed) {
            angle -= fan.angle * std::floor(angle / fan.angle);
        } else {
            angle -= kTurn * std::floor((angle + kLeastAngle) / kTurn);
            if (angle > fan.angle + kLeastAngle) {
                stopAtBoundary();
                return;
            }
        }
        angle = std::clamp(angle, 0.0, fan.angle);
        const auto after = std::ranges::upper_bound(fan.wedges, angle, {}, &FanWedge::start);
        const FanWedge& wedge = *(after == fan.wedges.begin() ? after : after - 1);
        face_ = wedge.face;
        exit_ = wedge.exit;
        at_ = wedge.source;
        direction_ = Eigen::Rotation2Dd(std::min(angle - wedge.start, wedge.width)) * wedge.first;
    }

    /// To the end, or to the side that the path leaves the face through.
    void step() {
        const FaceLayout layout = layoutOf(surface_, face_);
        const int a = (exit_ + 1) % 3;
        const int b = (exit_ + 2) % 3;
        const Vec2 side = layout.corners[b] - layout.corners[a];
        const Vec2 toSide = layout.corners[a] - at_;
        const double steep = cross(direction_, side);
        // Rounding alone makes a path parallel to the side that it leaves through.
        const double share =
            steep > 0.0 ? std::clamp(cross(toSide, direction_) / steep, 0.0, 1.0) : 0.5;
        const Vec2 there = layout.corners[a] + share * side;
        const double distance = std::max((there - at_).dot(direction_), 0.0);
        if (distance >= left_) {
            finish(layout);
            return;
        }
        left_ -= distance;
        path_.length += distance;
        SurfacePoint crossing{.face = face_, .barycentric = Vec3::Zero()};
        crossing.barycentric[a] = 1.0 - share;
        crossing.barycentric[b] = share;
        crossing = snapped(crossing, kOnEdgeBarycentric);
        path_.points.push_back(crossing);
        if (crossing.barycentric[a] == 0.0 || crossing.barycentric[b] == 0.0) {
            passVertex(crossing.barycentric[a] == 0.0 ? b : a);
        } else {
            passEdge(share, side);
        }
    }

    void passVertex(int corner) {
        const int vertex = surface_.faces()[face_][corner];
        if (surface_.isBoundaryVertex(vertex)) {
            stopAtBoundary();
            return;
        }
        const SurfaceFan fan = fanOfVertex(surface_, vertex);
        const auto wedge = std::ranges::find(fan.wedges, face_, &FanWedge::face);
        const Vec2 back = -direction_;
        const double within = angleBetween(wedge->first, back);
        leave(fan, wedge->start + std::clamp(within, 0.0, wedge->width) + 0.5 * fan.angle);
    }

    void passEdge(double share, const Vec2& side) {
        const int next = surface_.faceNeighbours()[face_][exit_];
        if (next < 0) {
            stopAtBoundary();
            return;
        }
        const Triangle& face = surface_.faces()[face_];
        const int a = cornerOf(surface_.faces()[next], face[(exit_ + 1) % 3]);
        const int b = cornerOf(surface_.faces()[next], face[(exit_ + 2) % 3]);
        const FaceLayout layout = layoutOf(surface_, next);
        const Vec2 along = side.normalized();
        const Vec2 newAlong = (layout.corners[b] - layout.corners[a]).normalized();
        direction_ = (direction_.dot(along) * newAlong -
                      std::max(cross(direction_, along), 0.0) * turnedLeft(newAlong))
                         .normalized();
        at_ = layout.corners[a] + share * (layout.corners[b] - layout.corners[a]);
        face_ = next;
        // Past the corner opposite to the side, on its left or on its right.
        const int apex = 3 - a - b;
        const bool isRightOfApex = cross(direction_, layout.corners[apex] - at_) > 0.0;
        exit_ = (apex + (isRightOfApex ? 1 : 2)) % 3;
    }

    void finish(const FaceLayout& layout) {
        const Vec2 end = at_ + left_ * direction_;
        const double first = end.y() / layout.corners[0].y();
        const double last = (end.x() - first * layout.corners[0].x()) / layout.corners[2].x();
        const SurfacePoint point{.face = face_, .barycentric = {first, 1.0 - first - last, last}};
        path_.points.push_back(snapped(point, kOnEdgeBarycentric));
        path_.length += left_;
        isGoing_ = false;
    }

    void stopAtBoundary() {
        path_.isWhole = false;
        isGoing_ = false;
    }

    const Surface& surface_;
    double left_;  // of the length
    StraightestPath path_;
    bool isGoing_ = true;
    int face_ = -1;
    int exit_ = 0;
    Vec2 at_ = Vec2::Zero(), direction_ = Vec2::Zero();
};

/// The sum of the normals of a fan's faces, each as often as its angle says.
Vec3 normalOf(const Surface& surface, const SurfaceFan& fan) {
    Vec3 sum = Vec3::Zero();
    for (const FanWedge& wedge : fan.wedges) {
        sum += wedge.width * surface.faceNormal(wedge.face);
    }
    return sum.normalized();
}

/// A direction of a face's layout, in space.
Vec3 inSpace(const Surface& surface, int face, const Vec2& direction) {
    const Triangle& corners = surface.faces()[face];
    const Vec3 along =
        (surface.vertices()[corners[2]] - surface.vertices()[corners[1]]).normalized();
    return direction.x() * along + direction.y() * surface.faceNormal(face).cross(along);
}

}  // namespace

StraightestPath straightestPath(
    const Surface& surface,
    const SurfacePoint& start,
    const SurfaceFan& fan,
    double angle,
    double length
) {
    return Tracer(surface, start, length).trace(fan, angle);
}

std::optional<double> angleOfDirection(
    const Surface& surface, const SurfaceFan& fan, const Vec3& direction
) {
    const Vec3 normal = normalOf(surface, fan);
    const Vec3 unit = direction.normalized();
    const Vec3 ahead = unit - unit.dot(normal) * normal;
    const Vec3 across = normal.cross(ahead);
    if (!(across.norm() > kLeastSine)) {
        return std::nullopt;
    }
    // Where the plane of direction and normal meets a wedge.
    for (const FanWedge& wedge : fan.wedges) {
        const Vec3 first = inSpace(surface, wedge.face, wedge.first);
        const Vec3 last = inSpace(surface, wedge.face, wedge.last);
        const double before = first.dot(across);
        const double behind = last.dot(across);
        if (before > 0.0 || behind < 0.0 || (before == 0.0 && behind == 0.0)) {
            continue;
        }
        const double share = before / (before - behind);
        const Vec2 flat = (1.0 - share) * wedge.first + share * wedge.last;
        const Vec3 met = (1.0 - share) * first + share * last;
        if (met.dot(ahead) > 0.0) {
            return wedge.start + angleBetween(wedge.first, flat);
        }
    }
    return std::nullopt;
}

}  // namespace bspline_curve
