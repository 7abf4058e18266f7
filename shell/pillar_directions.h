// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

#include <algorithm>
#include <span>

namespace bspline_curve {

/// Smallest cosine between a unit direction and a range of unit normals; 1 for none.
template <class Normals = std::span<const Vec3>>
[[nodiscard]] double leastCosine(const Vec3& direction, const Normals& normals) {
    double least = 1.0;
    for (const Vec3& normal : normals) {
        least = std::min(least, direction.dot(normal));
    }
    return least;
}

/// The unit direction with the largest leastCosine: the minimum-norm point of the convex hull of
/// the normals (Wolfe's problem on the sphere). Where no direction sees all normals from the front
/// (a singular vertex) the result's leastCosine is <= 0. Exact up to rounding for any number of
/// normals that real valences reach; O(m^4) worst, O(m^2) typical.
[[nodiscard]] Vec3 directionOfLeastAngle(std::span<const Vec3> normals);

}  // namespace bspline_curve
