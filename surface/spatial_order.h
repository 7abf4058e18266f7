// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"
#include "utility/large_array.h"

#include <algorithm>
#include <compare>
#include <cstdint>
#include <vector>

namespace bspline_curve {

/// Position on a Morton curve, and the element that has it.
struct MortonKey {
    std::uint64_t code;
    int index;
    auto operator<=>(const MortonKey&) const = default;
};

/// Morton code of a point of the cube from `low`, `extent` wide, in 2^21 cells per axis.
[[nodiscard]] std::uint64_t mortonCode(const Vec3& point, const Vec3& low, double extent);

/// Sorts keys, by buckets of their highest bits first: what is then sorted lies in the cache.
void sortByBuckets(std::vector<MortonKey>& keys);

/// Keys of the elements 0 to count - 1, whose positions centreOf(i) gives, along a Morton curve
/// through their bounding cube; elements in one cell by index. The same on every platform.
/// O(n log n).
template <class CentreOf>
[[nodiscard]] std::vector<MortonKey> spatialOrder(std::size_t count, const CentreOf& centreOf) {
    std::vector<MortonKey> keys = makeLarge(count, MortonKey{});
    if (count == 0) {
        return keys;
    }
    Vec3 low = centreOf(0);
    Vec3 high = low;
    for (std::size_t i = 1; i < count; ++i) {
        const auto& centre = centreOf(i);
        low = low.cwiseMin(centre);
        high = high.cwiseMax(centre);
    }
    const double extent = (high - low).maxCoeff();
    for (std::size_t i = 0; i < count; ++i) {
        keys[i] = {.code = mortonCode(centreOf(i), low, extent), .index = static_cast<int>(i)};
    }
    sortByBuckets(keys);
    return keys;
}

}  // namespace bspline_curve
