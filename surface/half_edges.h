// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

#include <algorithm>
#include <compare>
#include <cstddef>
#include <numeric>
#include <span>
#include <vector>

namespace bspline_curve {

/// The side of a face opposite to its corner k, which leads from corner k + 1 to corner k + 2.
struct HalfEdge {
    int low, high;  ///< its vertices
    int face, k;
    auto operator<=>(const HalfEdge&) const = default;
};

/// All half-edges of the faces, ascending, so that those between the same vertices follow each
/// other. O(n) where few faces meet in each vertex, else O(n log n).
[[nodiscard]] inline std::vector<HalfEdge> sortedHalfEdges(const std::vector<Triangle>& faces) {
    std::vector<HalfEdge> halfEdges(3 * faces.size());
    const auto forEachHalfEdge = [&](const auto& visit) {
        for (int f = 0; f < static_cast<int>(faces.size()); ++f) {
            for (int k = 0; k < 3; ++k) {
                const auto [low, high] = std::minmax(faces[f][(k + 1) % 3], faces[f][(k + 2) % 3]);
                visit(HalfEdge{low, high, f, k});
            }
        }
    };
    int end = 0;
    forEachHalfEdge([&](const HalfEdge& h) { end = std::max(end, h.low + 1); });
    constexpr std::size_t kMostSparse = 8;  // counting is dearer where few of the vertices are used
    if (static_cast<std::size_t>(end) > kMostSparse * halfEdges.size()) {
        auto next = halfEdges.begin();
        forEachHalfEdge([&](const HalfEdge& h) { *next++ = h; });
        std::ranges::sort(halfEdges);
        return halfEdges;
    }
    // A counting sort by the low vertex.
    std::vector<int> next(end + 1, 0);
    forEachHalfEdge([&](const HalfEdge& h) { ++next[h.low + 1]; });
    std::partial_sum(next.begin(), next.end(), next.begin());
    forEachHalfEdge([&](const HalfEdge& h) { halfEdges[next[h.low]++] = h; });
    for (int low = 0, first = 0; low < end; first = next[low++]) {
        std::sort(halfEdges.begin() + first, halfEdges.begin() + next[low]);
    }
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
