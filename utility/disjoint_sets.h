// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
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

    /// Unites two sets; returns the smallest element of the union.
    int unite(int i, int j) {
        const int a = find(i);
        const int b = find(j);
        const int low = std::min(a, b);
        parents_[std::max(a, b)] = low;
        return low;
    }

    /// The smallest element of each element's set.
    [[nodiscard]] std::vector<int> lowest() && {
        for (int& parent : parents_) {
            parent = parents_[parent];  // which is smaller, and has its own already
        }
        return std::move(parents_);
    }

    /// The number of each element's set, from 0 in order of the smallest elements, and how many
    /// sets there are.
    [[nodiscard]] std::pair<std::vector<int>, int> numbered() && {
        int count = 0;
        // Parents are smaller than their children, so they have their numbers already.
        for (int i = 0; i < static_cast<int>(parents_.size()); ++i) {
            parents_[i] = parents_[i] == i ? count++ : parents_[parents_[i]];
        }
        return {std::move(parents_), count};
    }

private:
    std::vector<int> parents_;
};

}  // namespace bspline_curve
