// SPDX-License-Identifier: GPL-3.0-or-later
#include "fill/crossing_finder.h"

#include "surface/self_intersection.h"
#include "utility/index_sets.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace bspline_curve {

std::vector<int> Crossings::faces() const {
    std::vector<int> all = withKept;
    for (const auto& [one, other] : pairs) {
        all.push_back(one);
        all.push_back(other);
    }
    sortUnique(all);
    return all;
}

CrossingFinder::CrossingFinder(const std::vector<Vec3>& vertices, const std::vector<Triangle>& kept)
    : vertices_(vertices) {
    keep(kept);
}

void CrossingFinder::keep(std::vector<Triangle> faces) {
    kept_.push_back(std::make_unique<const Kept>(vertices_, std::move(faces)));
}

bool CrossingFinder::crossesKept(const Triangle& face) const {
    const std::array corners{vertices_[face[0]], vertices_[face[1]], vertices_[face[2]]};
    return std::ranges::any_of(kept_, [&](const std::unique_ptr<const Kept>& kept) {
        bool crosses = false;
        kept->tree.forEachMeeting(corners, [&](int other) {
            crosses = crosses || trianglesIntersect(vertices_, face, kept->faces[other]);
        });
        return crosses;
    });
}

Crossings CrossingFinder::crossingsOf(const std::vector<Triangle>& faces) const {
    Crossings found;
    found.pairs = findSelfIntersections(vertices_, faces);
    found.withKept =
        indicesWhere<int>(faces.size(), [&](std::size_t f) { return crossesKept(faces[f]); });
    return found;
}

}  // namespace bspline_curve
