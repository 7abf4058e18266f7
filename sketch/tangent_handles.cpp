// SPDX-License-Identifier: GPL-3.0-or-later
#include "sketch/tangent_handles.h"

#include <Eigen/Geometry>

#include <cmath>

namespace bspline_curve {

namespace {

/// Of the normal and the pointer's direction: with less the plane is seen from the side.
constexpr double kLeastCosine = 0.05;
/// A pointer that is nearer to the pick, in pixels, leads nowhere.
constexpr double kLeastWay = 2.0;

double depthOf(const Pointer& pointer, const Vec3& point) {
    return (point - pointer.start).dot(pointer.direction);
}

}  // namespace

std::optional<Vec3> tangentHandle(
    const SketchPick& pick, int side, const Pointer& pointer, double pixels
) {
    const Vec3& tangent = side > 0 ? pick.tangent.after : pick.tangent.before;
    if (tangent.isZero(0.0)) {
        return std::nullopt;
    }
    const double reach = pixels * pointer.pixelAt(depthOf(pointer, pick.position));
    return pick.position + side * reach * tangent.normalized();
}

int tangentHandleUnder(
    const Pointer& pointer, double depth, const SketchPick& pick, double pixels, double radius
) {
    int under = 0;
    double least = radius;
    for (const int side : {1, -1}) {
        const std::optional<Vec3> handle = tangentHandle(pick, side, pointer, pixels);
        if (!handle) {
            continue;
        }
        const double along = depthOf(pointer, *handle);
        const Vec3 beside = *handle - pointer.start - along * pointer.direction;
        const double apart = beside.norm() / pointer.pixelAt(along);
        if (along > 0.0 && along <= depth + pixels * pointer.pixelAt(along) && apart < least) {
            least = apart;
            under = side;
        }
    }
    return under;
}

std::optional<Vec3> directionTowards(
    const Pointer& pointer, const SketchPick& pick, const Vec3& normal
) {
    const double cosine = pointer.direction.dot(normal);
    if (!(std::abs(cosine) >= kLeastCosine)) {
        return std::nullopt;
    }
    const double along = (pick.position - pointer.start).dot(normal) / cosine;
    const Vec3 way = pointer.start + along * pointer.direction - pick.position;
    if (!(along > 0.0) || !(way.norm() > kLeastWay * pointer.pixelAt(along))) {
        return std::nullopt;
    }
    return Vec3((way - way.dot(normal) * normal).normalized());
}

}  // namespace bspline_curve
