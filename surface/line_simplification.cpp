// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/line_simplification.h"

#include "surface/segment_distance.h"

#include <algorithm>
#include <cstddef>

namespace bspline_curve {

std::pair<int, double> farthestBetween(std::span<const Vec3> line, int from, int to) {
    std::pair<int, double> found(-1, 0.0);
    for (int i = from + 1; i < to; ++i) {
        const double distance = distanceToSegment(line[i], line[from], line[to]);
        if (distance > found.second) {
            found = {i, distance};
        }
    }
    return found;
}

std::vector<int> simplified(std::span<const Vec3> line, std::vector<int> kept, double within) {
    std::vector<std::pair<int, int>> waiting;
    for (std::size_t i = 1; i < kept.size(); ++i) {
        waiting.emplace_back(kept[i - 1], kept[i]);
    }
    while (!waiting.empty()) {
        const auto [from, to] = waiting.back();
        waiting.pop_back();
        const auto [farthest, distance] = farthestBetween(line, from, to);
        if (farthest >= 0 && distance > within) {
            kept.push_back(farthest);
            waiting.emplace_back(from, farthest);
            waiting.emplace_back(farthest, to);
        }
    }
    std::ranges::sort(kept);
    return kept;
}

}  // namespace bspline_curve
