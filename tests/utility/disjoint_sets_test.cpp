// SPDX-License-Identifier: GPL-3.0-or-later
#include "utility/disjoint_sets.h"

#include "support/seeds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace bspline_curve {
namespace {

TEST(DisjointSets, AreNamedByTheirSmallestElements) {
    constexpr int kCount = 60;
    test_support::forEachSeed(50, [&](test_support::Random& random) {
        DisjointSets sets(kCount);
        // The same by giving one set the name of the other, element by element.
        std::vector<int> names(kCount);
        std::iota(names.begin(), names.end(), 0);
        for (int step = 0; step < kCount; ++step) {
            const int i = random.integer(0, kCount - 1);
            const int j = random.integer(0, kCount - 1);
            sets.unite(i, j);
            const auto [low, high] = std::minmax({names[i], names[j]});
            std::ranges::replace(names, high, low);
            for (int k = 0; k < kCount; ++k) {
                ASSERT_EQ(sets.find(k), names[k]);
            }
        }
    });
}

}  // namespace
}  // namespace bspline_curve
