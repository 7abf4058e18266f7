// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/part_colours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <set>

namespace bspline_curve {

TEST(PartColours, TellManyPartsApart) {
    std::set<std::array<std::uint8_t, 3>> colours;
    constexpr int kParts = 50;
    for (int part = 0; part < kParts; ++part) {
        const auto colour = partColour(part);
        colours.insert(colour);
        EXPECT_EQ(*std::ranges::max_element(colour), 235);
        EXPECT_EQ(*std::ranges::min_element(colour), 95);
    }
    EXPECT_EQ(colours.size(), static_cast<std::size_t>(kParts));
}

}  // namespace bspline_curve
