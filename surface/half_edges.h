// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

#include <algorithm>
#include <compare>
#include <cstddef>
#include <span>
#include <vector>

namespace bspline_curve {

/// The side of a face opposite to its corner k, which leads from corner k + 1 to corner k + 2.
struct HalfEdge {
    int low, high;  ///< its vertices
    int face, k;
    auto operator<=>(const HalfEdge&) const = default;
};

/// All half-edges of the faces, so that those between the same vertices follow each other.
[[nodiscard]] inline std::vector<HalfEdge> sortedHalfEdges(const std::vector<Triangle>& faces) {
    std::vector<HalfEdge> halfEdges;
    halfEdges.reserve(3 * faces.size());
    for (int f = 0; f < static_cast<int>(faces.size()); ++f) {
        for (int k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(faces[f][(k + 1) % 3], faces[f][(k + 2) % 3]);
            halfEdges.push_back({low, high, f, k});
        }
    }
    std::ranges::sort(halfEdges);
    return halfEdges;
}

/// Calls visit(span of half-edges) for each edge.
template <class Visitor>
void forEachEdge(const std::vector<HalfEdge>& sorted, const Visitor& visit) {
    for (std::size_t first = 0; first < sorted.size();) {
        std::size_t last = first + 1;
        while (last < sorted.size() && sorted[last].low == sorted[first].low &&
               sorted[last].high == sorted[first].high) {
            ++last;
        }
        visit(std::span<const HalfEdge>(sorted.data() + first, last - first));
        first = last;
    }
}

/// Whether two half-edges of one edge lead the same way, so that one of their faces is turned over.
[[nodiscard]] inline bool areParallel(
    const std::vector<Triangle>& faces, const HalfEdge& a, const HalfEdge& b
) {
    return faces[a.face][(a.k + 1) % 3] == faces[b.face][(b.k + 1) % 3];
}

}  // namespace bspline_curve
