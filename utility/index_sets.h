// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace bspline_curve {

/// Sorts and drops what is there more than once.
template <class T>
void sortUnique(std::vector<T>& values) {
    std::ranges::sort(values);
    const auto repeated = std::ranges::unique(values);
    values.erase(repeated.begin(), repeated.end());
}

/// Whether a value is in a list. O(n).
template <class T>
[[nodiscard]] bool contains(const std::vector<T>& list, const T& value) {
    return std::ranges::find(list, value) != list.end();
}

/// The numbers in [0, count) for which a condition holds, ascending.
template <class Index, class Condition>
[[nodiscard]] std::vector<Index> indicesWhere(std::size_t count, const Condition& condition) {
    std::vector<Index> indices;
    for (std::size_t i = 0; i < count; ++i) {
        if (condition(i)) {
            indices.push_back(static_cast<Index>(i));
        }
    }
    return indices;
}

/// Place of a value in an ascending list without repetitions; -1 where it is not there. O(log n).
[[nodiscard]] inline int indexIn(const std::vector<int>& values, int value) {
    const auto found = std::ranges::lower_bound(values, value);
    return found != values.end() && *found == value ? static_cast<int>(found - values.begin()) : -1;
}

}  // namespace bspline_curve
