// SPDX-License-Identifier: GPL-3.0-or-later
#include "field/elimination_order.h"

#include "utility/disjoint_sets.h"

#include <algorithm>
#include <cstddef>
#include <functional>

namespace bspline_curve {
namespace {

// The edges of a spanning forest of the largest weights (Kruskal).
std::vector<CoupledRows> forestOf(int rowCount, std::vector<CoupledRows> edges) {
    std::ranges::stable_sort(edges, std::ranges::greater(), &CoupledRows::weight);
    DisjointSets trees(rowCount);
    std::erase_if(edges, [&](const CoupledRows& edge) {
        const bool isWithin = trees.find(edge.from) == trees.find(edge.to);
        trees.unite(edge.from, edge.to);
        return isWithin;
    });
    return edges;
}

// Neighbours of i are from offsets[i] on.
struct Neighbours {
    std::vector<int> offsets;
    std::vector<int> rows;
};

Neighbours neighboursIn(const std::vector<CoupledRows>& edges, int rowCount) {
    Neighbours neighbours{std::vector<int>(rowCount + 1), std::vector<int>(2 * edges.size())};
    auto& [offsets, rows] = neighbours;
    for (const CoupledRows& edge : edges) {
        ++offsets[edge.from];
        ++offsets[edge.to];
    }
    int end = 0;
    for (int& offset : offsets) {
        offset = end += offset;
    }
    for (const CoupledRows& edge : edges) {
        rows[--offsets[edge.from]] = edge.to;
        rows[--offsets[edge.to]] = edge.from;
    }
    return neighbours;
}

}  // namespace

std::vector<int> eliminationOrder(int rowCount, std::vector<CoupledRows> edges) {
    const auto [offsets, neighbours] = neighboursIn(forestOf(rowCount, std::move(edges)), rowCount);
    std::vector<int> order;
    order.reserve(rowCount);
    std::vector<bool> isSeen(rowCount);
    // The other way round: each last row as a root, and what hangs on it, level by level.
    for (int last = rowCount; last-- > 0;) {
        if (isSeen[last]) {
            continue;
        }
        isSeen[last] = true;
        order.push_back(last);
        for (std::size_t next = order.size() - 1; next < order.size(); ++next) {
            const int row = order[next];
            for (int i = offsets[row]; i < offsets[row + 1]; ++i) {
                if (!isSeen[neighbours[i]]) {
                    isSeen[neighbours[i]] = true;
                    order.push_back(neighbours[i]);
                }
            }
        }
    }
    std::ranges::reverse(order);
    return order;
}

}  // namespace bspline_curve
