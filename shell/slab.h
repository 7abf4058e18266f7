// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/shell.h"
#include "surface/predicates.h"

#include <array>
#include <utility>

namespace bspline_curve {

/// The corners of tetrahedron i of a slab, in the order of kSlabSplit. `pointOf(slot, outer)`: a
/// reference to the tip of the slot's pillar, or to its middle.
template <class PointOf>
[[nodiscard]] std::array<const Vec3*, 4> slabCorners(std::size_t i, const PointOf& pointOf) {
    std::array<const Vec3*, 4> corners{};
    for (std::size_t k = 0; k < 4; ++k) {
        corners[k] = &pointOf(kSlabSplit[i][k].slot, kSlabSplit[i][k].outer);
    }
    return corners;
}

/// Whether every tetrahedron of a slab has this orientation, that of its prism above the middle and
/// the opposite one below (exact).
template <class PointOf>
[[nodiscard]] bool slabIsUpright(int orientation, const PointOf& pointOf) {
    for (std::size_t i = 0; i < kSlabSplit.size(); ++i) {
        const auto [a, b, c, d] = slabCorners(i, pointOf);
        if (orientationSign(*a, *b, *c, *d) != orientation) {
            return false;
        }
    }
    return true;
}

/// Whether a closed tetrahedron of this orientation holds a point (exact).
[[nodiscard]] inline bool tetrahedronHolds(
    std::array<const Vec3*, 4> corners, int orientation, const Vec3& point
) {
    for (const Vec3*& corner : corners) {
        const Vec3* const kept = std::exchange(corner, &point);
        if (orientationSign(*corners[0], *corners[1], *corners[2], *corners[3]) == -orientation) {
            return false;
        }
        corner = kept;
    }
    return true;
}

/// Whether a closed slab, upright as above, holds a point (exact).
template <class PointOf>
[[nodiscard]] bool slabHolds(int orientation, const PointOf& pointOf, const Vec3& point) {
    for (std::size_t i = 0; i < kSlabSplit.size(); ++i) {
        if (tetrahedronHolds(slabCorners(i, pointOf), orientation, point)) {
            return true;
        }
    }
    return false;
}

}  // namespace bspline_curve
