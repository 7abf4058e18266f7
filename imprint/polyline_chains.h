// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

namespace bspline_curve {

/// Points joined by edges, in order; a closed chain does not repeat its first point.
struct PolylineChain {
    std::vector<int> points;
    bool closed = false;
};

/// The edges of a polyline layer as chains, cut where more than two edges meet. Each runs the way
/// of its first edge; an open one from its end. Every edge is in one of them. O(n).
[[nodiscard]] std::vector<PolylineChain> chainsOf(
    int pointCount, const std::vector<std::array<int, 2>>& edges
);

}  // namespace bspline_curve
