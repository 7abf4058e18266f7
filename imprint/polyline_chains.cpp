// SPDX-License-Identifier: GPL-3.0-or-later
#include "imprint/polyline_chains.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace bspline_curve {

namespace {

class ChainWalker {
public:
    ChainWalker(int pointCount, const std::vector<std::array<int, 2>>& edges)
        : edges_(edges), edgesAt_(pointCount), isTaken_(edges.size(), 0) {
        for (std::size_t e = 0; e < edges.size(); ++e) {
            for (const int point : edges[e]) {
                edgesAt_[point].push_back(static_cast<int>(e));
            }
        }
    }

    std::vector<PolylineChain> walk() {
        std::vector<PolylineChain> chains;
        for (std::size_t e = 0; e < edges_.size(); ++e) {
            if (isTaken_[e] == 0) {
                chains.push_back(chainFrom(static_cast<int>(e)));
            }
        }
        return chains;
    }

private:
    PolylineChain chainFrom(int edge) {
        isTaken_[edge] = 1;
        const auto [first, second] = edges_[edge];
        PolylineChain chain;
        chain.points = wayFrom(second);
        if (chain.points.back() == first) {
            chain.closed = true;
            return chain;
        }
        std::vector<int> before = wayFrom(first);
        std::ranges::reverse(before);
        before.insert(before.end(), chain.points.begin(), chain.points.end());
        chain.points = std::move(before);
        if (chain.points.size() > 2 && chain.points.front() == chain.points.back()) {
            chain.points.pop_back();
            chain.closed = true;
        }
        return chain;
    }

    /// From a point along edges that are not taken, up to where it ends, closes or branches.
    std::vector<int> wayFrom(int point) {
        std::vector<int> way{point};
        while (edgesAt_[way.back()].size() == 2) {
            const std::vector<int>& both = edgesAt_[way.back()];
            const int next = isTaken_[both[0]] == 0 ? both[0] : both[1];
            if (isTaken_[next] != 0) {
                break;
            }
            isTaken_[next] = 1;
            const auto [a, b] = edges_[next];
            way.push_back(a == way.back() ? b : a);
        }
        return way;
    }

    const std::vector<std::array<int, 2>>& edges_;
    std::vector<std::vector<int>> edgesAt_;
    std::vector<char> isTaken_;
};

}  // namespace

std::vector<PolylineChain> chainsOf(int pointCount, const std::vector<std::array<int, 2>>& edges) {
    return ChainWalker(pointCount, edges).walk();
}

}  // namespace bspline_curve
