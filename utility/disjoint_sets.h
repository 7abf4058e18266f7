// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace bspline_curve {

/// Disjoint sets of the numbers below a count, by a forest whose paths are halved.
class DisjointSets {
public:
    explicit DisjointSets(std::size_t count) : parents_(count) {
        std::iota(parents_.begin(), parents_.end(), 0);
    }

    /// The smallest element of the set that holds i.
    [[nodiscard]] int find(int i) {
        while (parents_[i] != i) {
            i = parents_[i] = parents_[parents_[i]];
        }
        return i;
    }

    void unite(int i, int j) {
        const auto [low, high] = std::minmax({find(i), find(j)});
        parents_[high] = low;
    }

private:
    std::vector<int> parents_;
};

}  // namespace bspline_curve
