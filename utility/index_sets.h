// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

namespace bspline_curve {

/// Sorts and drops what is there more than once.
template <class T>
void sortUnique(std::vector<T>& values) {
    std::ranges::sort(values);
    const auto repeated = std::ranges::unique(values);
    values.erase(repeated.begin(), repeated.end());
}

/// Place of a value in an ascending list without repetitions; -1 where it is not there. O(log n).
[[nodiscard]] inline int indexIn(const std::vector<int>& values, int value) {
    const auto found = std::ranges::lower_bound(values, value);
    return found != values.end() && *found == value ? static_cast<int>(found - values.begin()) : -1;
}

}  // namespace bspline_curve
