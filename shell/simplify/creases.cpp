// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/simplify/operations.h"

#include <algorithm>

namespace bspline_curve {
Creases::Creases(std::vector<std::pair<int, int>> edges, int pillarCount)
    : edges_(std::move(edges)), degrees_(pillarCount, 0) {
    for (const auto& [a, b] : edges_) {
        ++degrees_[a];
        ++degrees_[b];
    }
}

bool Creases::holdEdge(int a, int b) const {
    return std::ranges::binary_search(edges_, std::pair(std::min(a, b), std::max(a, b)));
}

void Creases::collapse(int removed, int kept) {
    const auto firstOf = [&](const std::pair<int, int>& edge) {
        return std::ranges::lower_bound(edges_, edge);
    };
    // The collapsed edge goes; the other one of `removed` becomes one of `kept`. Edges are few.
    const auto other = std::ranges::find_if(edges_, [&](const std::pair<int, int>& edge) {
        return (edge.first == removed && edge.second != kept) ||
               (edge.second == removed && edge.first != kept);
    });
    const int far = other->first == removed ? other->second : other->first;
    edges_.erase(other);
    edges_.erase(firstOf({std::min(removed, kept), std::max(removed, kept)}));
    const std::pair<int, int> moved(std::min(far, kept), std::max(far, kept));
    edges_.insert(firstOf(moved), moved);
    degrees_[removed] = 0;
}

}  // namespace bspline_curve
