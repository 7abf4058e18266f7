// SPDX-License-Identifier: GPL-3.0-or-later
#include "imprint/polyline_chains.h"

#include <gtest/gtest.h>

#include <string>

namespace bspline_curve {
namespace {

/// "0-1-2 3-4-3": each chain, a closed one with its first point again.
std::string text(int points, const std::vector<std::array<int, 2>>& edges) {
    std::string result;
    for (const PolylineChain& chain : chainsOf(points, edges)) {
        result += result.empty() ? "" : " ";
        for (std::size_t i = 0; i < chain.points.size(); ++i) {
            result += i > 0 ? "-" : "";
            result += std::to_string(chain.points[i]);
        }
        if (chain.closed) {
            result += "-";
            result += std::to_string(chain.points.front());
        }
    }
    return result;
}

TEST(PolylineChains, AreInOrderFromTheirEnds) {
    EXPECT_EQ(text(4, {{0, 1}, {1, 2}, {2, 3}}), "0-1-2-3");
    EXPECT_EQ(text(4, {{1, 2}, {2, 3}, {0, 1}}), "0-1-2-3");
    EXPECT_EQ(text(4, {{1, 0}, {2, 1}, {3, 2}}), "3-2-1-0");
    EXPECT_EQ(text(5, {{0, 1}, {3, 4}}), "0-1 3-4");
    EXPECT_EQ(text(2, {}), "");
}

TEST(PolylineChains, CloseWhereEdgesDo) {
    EXPECT_EQ(text(3, {{0, 1}, {1, 2}, {2, 0}}), "1-2-0-1");
    EXPECT_EQ(text(4, {{0, 1}, {1, 2}, {2, 3}, {3, 0}}), "1-2-3-0-1");
}

TEST(PolylineChains, EndWhereMoreThanTwoEdgesMeet) {
    EXPECT_EQ(text(5, {{0, 1}, {1, 2}, {1, 3}, {3, 4}}), "0-1 1-2 1-3-4");
    // A loop with a tail, a figure of eight.
    EXPECT_EQ(text(4, {{3, 0}, {0, 1}, {1, 2}, {2, 0}}), "3-0 1-2-0-1");
    EXPECT_EQ(text(4, {{1, 2}, {2, 0}, {0, 1}, {0, 3}}), "0-1-2-0 0-3");
    EXPECT_EQ(text(5, {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {3, 4}, {4, 0}}), "1-2-0-1 3-4-0-3");
}

}  // namespace
}  // namespace bspline_curve
