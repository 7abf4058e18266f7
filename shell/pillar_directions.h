// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/patch_levels.h"

#include <algorithm>
#include <span>
#include <vector>

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
/// (a singular vertex) the result's leastCosine is <= 0. Exact up to rounding, whatever the order
/// of the normals. Takes a few passes over them, fewer than 20 on all meshes seen: O(m).
[[nodiscard]] Vec3 directionOfLeastAngle(std::span<const Vec3> normals);

/// The largest patches of a surface that are still many enough to smooth directions over: no wider
/// than 0.005 times the root of its area. Null where its faces are hardly smaller than that.
[[nodiscard]] const PatchLevels::Level* patchesToSmoothOver(const PatchLevels& patches);

/// Unit directions of the finest patches, as smooth as averages over patchesToSmoothOver(), which
/// must be there, and their neighbours' neighbours. `faceNormals`: unit. O(#F).
[[nodiscard]] std::vector<Vec3> smoothPatchDirections(
    const PatchLevels& patches, const std::vector<Vec3>& faceNormals
);

}  // namespace bspline_curve
