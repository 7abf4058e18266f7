// SPDX-License-Identifier: GPL-3.0-or-later
#include "utility/sparse_map.h"

#include "support/random.h"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace bspline_curve {
namespace {

TEST(SparseMaps, HoldWhatAnOrdinaryMapHolds) {
    test_support::Random random(31);
    SparseMap<int> sparse;
    for (int round = 0; round < 5; ++round) {
        SCOPED_TRACE("seed 31, round " + std::to_string(round));
        sparse.clear();
        std::map<int, int> ordinary;
        for (int i = 0; i < 3000; ++i) {
            const int id = random.integer(0, round % 2 == 0 ? 4000 : 2'000'000'000);
            EXPECT_EQ(sparse.contains(id), ordinary.contains(id));
            int& value = sparse.at(id, i);
            EXPECT_EQ(value, ordinary.emplace(id, i).first->second);
            value = 2 * i;
            ordinary[id] = 2 * i;
        }
        EXPECT_EQ(sparse.size(), ordinary.size());
        for (const auto& [id, value] : ordinary) {
            ASSERT_NE(sparse.find(id), nullptr);
            EXPECT_EQ(*sparse.find(id), value);
        }
    }
}

TEST(SparseMaps, AreEmptyAtFirst) {
    const SparseMap<int> sparse;
    EXPECT_FALSE(sparse.contains(0));
    EXPECT_EQ(sparse.size(), 0U);
}

}  // namespace
}  // namespace bspline_curve
