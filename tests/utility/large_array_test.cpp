// SPDX-License-Identifier: GPL-3.0-or-later
#include "utility/large_array.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace bspline_curve {
namespace {

// From none to several large pages, and sizes that end within one.
constexpr std::size_t kCounts[] = {0, 1, 1000, 524'287, 524'288, 3'000'001};

TEST(LargeArray, HoldsWhatItIsFilledWith) {
    for (const std::size_t count : kCounts) {
        const std::vector<int> elements = makeLarge(count, 7);
        EXPECT_EQ(elements.size(), count);
        EXPECT_EQ(std::ranges::count(elements, 7), static_cast<std::ptrdiff_t>(count));
    }
}

TEST(LargeArray, ReservingKeepsWhatIsThere) {
    for (const std::size_t count : kCounts) {
        std::vector<int> elements(777);
        std::iota(elements.begin(), elements.end(), 0);
        const std::vector<int> before = elements;
        reserveLarge(elements, count);
        EXPECT_GE(elements.capacity(), count);
        EXPECT_EQ(elements, before);
        const int* const place = elements.data();
        elements.resize(std::max<std::size_t>(count, 777), -1);
        EXPECT_EQ(elements.data(), place);
        EXPECT_TRUE(std::equal(before.begin(), before.end(), elements.begin()));
    }
}

}  // namespace
}  // namespace bspline_curve
