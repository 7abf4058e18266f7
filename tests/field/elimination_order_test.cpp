// SPDX-License-Identifier: GPL-3.0-or-later
#include "field/elimination_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace bspline_curve {
namespace {

std::vector<int> placesIn(const std::vector<int>& order) {
    std::vector<int> places(order.size(), -1);
    for (int place = 0; place < static_cast<int>(order.size()); ++place) {
        places[order[place]] = place;
    }
    return places;
}

std::vector<int> firstNumbers(int count) {
    std::vector<int> numbers(count);
    std::iota(numbers.begin(), numbers.end(), 0);
    return numbers;
}

TEST(EliminationOrder, LeavesRowsWithoutEdgesWhereTheyAre) {
    EXPECT_EQ(eliminationOrder(5, {}), firstNumbers(5));
    EXPECT_TRUE(eliminationOrder(0, {}).empty());
}

// A ring whose rows are numbered at random: all but its weakest edge are in the forest.
TEST(EliminationOrder, LeavesEachRowOneNeighbourInTheForest) {
    constexpr int kCount = 200;
    std::vector<int> ring = firstNumbers(kCount);
    std::ranges::shuffle(ring, std::mt19937(5));
    std::vector<CoupledRows> edges;
    for (int i = 0; i < kCount; ++i) {
        edges.push_back({ring[i], ring[(i + 1) % kCount], i == 17 ? 2.0 : 3.0 + i});
    }
    const std::vector<int> order = eliminationOrder(kCount + 10, edges);
    std::vector<int> sorted = order;
    std::ranges::sort(sorted);
    ASSERT_EQ(sorted, firstNumbers(kCount + 10));
    const std::vector<int> places = placesIn(order);
    edges.erase(edges.begin() + 17);
    std::vector<int> later(order.size());
    for (const auto& [from, to, weight] : edges) {
        ++later[places[from] < places[to] ? from : to];
    }
    EXPECT_EQ(*std::ranges::max_element(later), 1);
}

// A triangle: its weakest edge gives way. Row 1 has no edge, and its place.
TEST(EliminationOrder, FollowsTheLargestWeightsToTheLastRow) {
    EXPECT_EQ(
        eliminationOrder(5, {{0, 2, 5.0}, {2, 4, 1.0}, {4, 0, 3.0}}), (std::vector{1, 3, 2, 0, 4})
    );
}

}  // namespace
}  // namespace bspline_curve
