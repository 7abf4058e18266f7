// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/spatial_order.h"

#include <numeric>

namespace bspline_curve {
namespace {

constexpr int kMortonBitsPerAxis = 21;

// Spreads the lower 21 bits: bit i moves to bit 3 i.
std::uint64_t spreadBits(std::uint64_t x) {
    x &= 0x1fffffU;
    x = (x | x << 32U) & 0x001f00000000ffffU;
    x = (x | x << 16U) & 0x001f0000ff0000ffU;
    x = (x | x << 8U) & 0x100f00f00f00f00fU;
    x = (x | x << 4U) & 0x10c30c30c30c30c3U;
    x = (x | x << 2U) & 0x1249249249249249U;
    return x;
}

}  // namespace

std::uint64_t mortonCode(const Vec3& point, const Vec3& low, double extent) {
    constexpr double kCells = (1U << static_cast<unsigned>(kMortonBitsPerAxis)) - 1U;
    const Vec3 cell = extent > 0.0 ? Vec3((point - low) / extent * kCells) : Vec3::Zero();
    return spreadBits(static_cast<std::uint64_t>(cell[0])) << 2U |
           spreadBits(static_cast<std::uint64_t>(cell[1])) << 1U |
           spreadBits(static_cast<std::uint64_t>(cell[2]));
}

void sortByBuckets(std::vector<MortonKey>& keys) {
    // Six bits per axis.
    constexpr int kBucketBits = 18;
    constexpr std::size_t kBuckets = std::size_t{1} << static_cast<unsigned>(kBucketBits);
    constexpr auto kShift = static_cast<unsigned>(3 * kMortonBitsPerAxis - kBucketBits);
    if (keys.size() < kBuckets) {
        std::ranges::sort(keys);
        return;
    }
    std::vector<std::uint32_t> ends(kBuckets + 1);
    for (const MortonKey& key : keys) {
        ++ends[(key.code >> kShift) + 1];
    }
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    std::vector<MortonKey> sorted = makeLarge(keys.size(), MortonKey{});
    for (const MortonKey& key : keys) {
        sorted[ends[key.code >> kShift]++] = key;  // its bucket's start becomes its end
    }
    auto begin = sorted.begin();
    for (const std::uint32_t end : ends) {
        const auto last = sorted.begin() + static_cast<std::ptrdiff_t>(end);
        std::sort(begin, last);
        begin = last;
    }
    keys.swap(sorted);
}

}  // namespace bspline_curve
