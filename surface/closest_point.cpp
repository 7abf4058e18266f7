// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/closest_point.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace bspline_curve {

namespace {

/// Parameter in [0, 1] of the point of the segment (a, b) that is closest to a query.
double closestParameter(const Vec3& a, const Vec3& b, const Vec3& query) {
    const Vec3 direction = b - a;
    const double squaredLength = direction.squaredNorm();
    if (!(squaredLength > 0.0)) {
        return 0.0;
    }
    return std::clamp((query - a).dot(direction) / squaredLength, 0.0, 1.0);
}

}  // namespace

ClosestPointOnTriangle closestPointOnTriangle(
    const std::vector<Vec3>& vertices, const Triangle& triangle, const Vec3& query
) {
    const auto corner = [&](int k) -> const Vec3& { return vertices[triangle[k]]; };
    const auto at = [&](const Vec3& barycentric) {
        const Vec3 position =
            barycentric[0] * corner(0) + barycentric[1] * corner(1) + barycentric[2] * corner(2);
        return ClosestPointOnTriangle{
            .barycentric = barycentric,
            .position = position,
            .squaredDistance = (query - position).squaredNorm(),
        };
    };

    // Step 1: the edges. Each runs from its lower to its higher vertex index, so that both faces of
    // an edge compute the same.
    ClosestPointOnTriangle best = at(Vec3::UnitX());
    for (int k = 0; k < 3; ++k) {
        int from = (k + 1) % 3;
        int to = (k + 2) % 3;
        if (triangle[from] > triangle[to]) {
            std::swap(from, to);
        }
        const double t = closestParameter(corner(from), corner(to), query);
        Vec3 barycentric = Vec3::Zero();
        barycentric[from] = 1.0 - t;
        barycentric[to] = t;
        const ClosestPointOnTriangle candidate = at(barycentric);
        if (candidate.squaredDistance < best.squaredDistance) {
            best = candidate;
        }
    }

    // Step 2: the interior, where the foot of the perpendicular lies in it. In a needle rounding
    // may misplace the foot along it; so it counts only where it is closer than the edges.
    const Vec3 edge1 = corner(1) - corner(0);
    const Vec3 edge2 = corner(2) - corner(0);
    const Vec3 normal = edge1.cross(edge2);
    const double squaredNormal = normal.squaredNorm();
    if (squaredNormal > 0.0) {
        const Vec3 offset = query - corner(0);
        const double b1 = offset.cross(edge2).dot(normal) / squaredNormal;
        const double b2 = edge1.cross(offset).dot(normal) / squaredNormal;
        const double b0 = 1.0 - b1 - b2;
        if (b0 > 0.0 && b1 > 0.0 && b2 > 0.0) {
            const ClosestPointOnTriangle candidate = at(Vec3(b0, b1, b2));
            if (candidate.squaredDistance < best.squaredDistance) {
                best = candidate;
            }
        }
    }
    return best;
}

}  // namespace bspline_curve
