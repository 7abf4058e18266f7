// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/spatial_order.h"

#include "support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

// Fewer keys than there are buckets, and more; spread, and many in one bucket or equal.
TEST(SpatialOrder, IsThatOfAllCodesThenOfNumbers) {
    for (const int count : {0, 1, 1000, 300'000}) {
        for (const int highestBit : {63, 50, 20, 3}) {
            SCOPED_TRACE(
                std::to_string(count) + " keys of " + std::to_string(highestBit) + " bits"
            );
            Random random(5);
            std::vector<MortonKey> keys;
            for (int i = 0; i < count; ++i) {
                std::uint64_t code = 0;
                for (int part = 0; part < 3; ++part) {
                    code =
                        code << 21U | static_cast<std::uint64_t>(random.integer(0, (1 << 21) - 1));
                }
                keys.push_back({code >> static_cast<unsigned>(63 - highestBit), i});
            }
            std::vector<MortonKey> expected = keys;
            std::ranges::sort(expected);
            sortByBuckets(keys);
            EXPECT_EQ(keys, expected);
        }
    }
}

TEST(SpatialOrder, HoldsTheHighestCode) {
    constexpr std::uint64_t kHighest = (std::uint64_t{1} << 63U) - 1;
    std::vector<MortonKey> keys(300'000, {kHighest, 0});
    for (std::size_t i = 0; i < keys.size(); ++i) {
        keys[i].index = static_cast<int>(keys.size() - i);
    }
    sortByBuckets(keys);
    EXPECT_TRUE(std::ranges::is_sorted(keys));
    EXPECT_EQ(keys.front().index, 1);
}

}  // namespace
}  // namespace bspline_curve
