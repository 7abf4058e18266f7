// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/pillar_points.h"

#include <utility>

namespace bspline_curve {

PillarPoints::PillarPoints(const std::vector<Pillar>& pillars) {
    points.reserve(kLevels * pillars.size());
    for (const Pillar& pillar : pillars) {
        points.insert(points.end(), {pillar.bottom, pillar.middle, pillar.top});
    }
}

std::array<int, 4> tetrahedronPoints(const Triangle& slots, int inPrism) {
    const Level outer = kOuterLevels[inPrism / 3];
    std::array<int, 4> points{};
    for (std::size_t k = 0; k < 4; ++k) {
        const SplitVertex vertex = kSlabSplit[inPrism % 3][k];
        points[k] = PillarPoints::indexOf(slots[vertex.slot], vertex.outer ? outer : Level::Middle);
    }
    return points;
}

std::array<Triangle, 4> wallTriangles(const Triangle& slots, std::size_t slot) {
    const int low = slots[slot == 0 ? 1 : 0];
    const int high = slots[slot == 2 ? 1 : 2];
    std::array<Triangle, 4> triangles{};
    for (std::size_t slab = 0; slab < 2; ++slab) {
        const int start = PillarPoints::indexOf(low, Level::Middle);
        const int diagonal = PillarPoints::indexOf(high, kOuterLevels[slab]);
        triangles[2 * slab] = {start, PillarPoints::indexOf(high, Level::Middle), diagonal};
        triangles[2 * slab + 1] = {start, diagonal, PillarPoints::indexOf(low, kOuterLevels[slab])};
    }
    return triangles;
}

bool Slab::holds(const Vec3& point) const {
    // A tetrahedron holds the point if none turns over with the point in the place of a corner.
    const auto tetrahedronHolds = [&](std::array<const Vec3*, 4> c) {
        for (const Vec3*& corner : c) {
            const Vec3* const kept = std::exchange(corner, &point);
            if (orientationSign(*c[0], *c[1], *c[2], *c[3]) == -sign()) {
                return false;
            }
            corner = kept;
        }
        return true;
    };
    return tetrahedronHolds(corners(0)) || tetrahedronHolds(corners(1)) ||
           tetrahedronHolds(corners(2));
}

}  // namespace bspline_curve
