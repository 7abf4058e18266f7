// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/strip_search.h"

#include "support/many_cases.h"
#include "support/meshes.h"
#include "support/random.h"
#include "surface/surface_point.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

constexpr double kNever = std::numeric_limits<double>::infinity();

Vec3 middleBetween(const Surface& surface, int face, int neighbour) {
    const Triangle& neighbours = surface.faceNeighbours()[face];
    const auto k =
        static_cast<std::size_t>(std::ranges::find(neighbours, neighbour) - neighbours.begin());
    const Triangle& corners = surface.faces()[face];
    return 0.5 *
           (surface.vertices()[corners[(k + 1) % 3]] + surface.vertices()[corners[(k + 2) % 3]]);
}

/// What the way in a strip costs, over the midpoints of its edges.
double costOf(
    const Surface& surface,
    const std::vector<int>& strip,
    const std::vector<double>& costs,
    const SurfacePoint& start,
    const SurfacePoint& goal
) {
    double sum = 0.0;
    Vec3 from = surface.position(start);
    for (std::size_t i = 0; i < strip.size(); ++i) {
        const Vec3 to = i + 1 < strip.size() ? middleBetween(surface, strip[i], strip[i + 1])
                                             : surface.position(goal);
        sum += costs[strip[i]] * (to - from).norm();
        from = to;
    }
    return sum;
}

/// The least cost of all ways, by relaxing every face until nothing changes: no queue, no estimate.
double leastCost(
    const Surface& surface,
    const std::vector<double>& costs,
    const SurfacePoint& start,
    const SurfacePoint& goal
) {
    const auto isOpen = [&](int f) { return f >= 0 && std::isfinite(costs[f]); };
    // Of the way into a face over each of its edges.
    std::vector<std::array<double, 3>> entry(surface.faces().size(), {kNever, kNever, kNever});
    const auto solveSampled = [&](int f, const Vec3& from, double cost) {
        bool isChanged = false;
        for (const int g : surface.faceNeighbours()[f]) {
            if (!isOpen(g)) {
                continue;
            }
            const Triangle& back = surface.faceNeighbours()[g];
            double& known = entry[g][static_cast<int>(std::ranges::find(back, f) - back.begin())];
            const double offered = cost + costs[f] * (middleBetween(surface, f, g) - from).norm();
            if (offered < known) {
                known = offered;
                isChanged = true;
            }
        }
        return isChanged;
    };
    for (const int f : facesHolding(surface, start)) {
        if (isOpen(f)) {
            solveSampled(f, surface.position(start), 0.0);
        }
    }
    for (bool isChanged = true; isChanged;) {
        isChanged = false;
        for (int f = 0; f < surface.faceCount(); ++f) {
            for (std::size_t k = 0; k < 3; ++k) {
                const double cost = entry[f][k];
                if (std::isfinite(cost)) {
                    const int g = surface.faceNeighbours()[f][k];
                    isChanged |= solveSampled(f, middleBetween(surface, f, g), cost);
                }
            }
        }
    }
    double least = kNever;
    for (const int f : facesHolding(surface, goal)) {
        for (std::size_t k = 0; k < 3; ++k) {
            if (std::isfinite(entry[f][k])) {
                const int g = surface.faceNeighbours()[f][k];
                const Vec3 last = surface.position(goal) - middleBetween(surface, f, g);
                least = std::min(least, entry[f][k] + costs[f] * last.norm());
            }
        }
    }
    return least;
}

class StripsOfLeastCost : public testing::TestWithParam<std::uint64_t> {
protected:
    SurfacePoint randomPoint() {
        SurfacePoint point{random_.integer(0, surface_.faceCount() - 1), random_.barycentric()};
        if (random_.integer(0, 1) == 0) {
            point.barycentric = Vec3::Unit(random_.integer(0, 2));
        }
        return point;
    }

    Random random_{GetParam()};
    Surface surface_{withNoise(icosphere(2), 0.03, GetParam())};
    testing::ScopedTrace trace_{__FILE__, __LINE__, "seed " + std::to_string(GetParam())};
};

TEST_P(StripsOfLeastCost, AreThoseOfAnExhaustiveSearch) {
    for (int i = 0; i < caseCount(20, 4); ++i) {
        SCOPED_TRACE("case " + std::to_string(i));
        std::vector<double> costs;
        for (int f = 0; f < surface_.faceCount(); ++f) {
            costs.push_back(random_.integer(0, 4) == 0 ? kNever : random_.uniform(1.0, 20.0));
        }
        StripSearch search(
            surface_, {[&](int f) { return costs[f]; }, *std::ranges::min_element(costs)}
        );
        for (int query = 0; query < 10; ++query) {
            SCOPED_TRACE("query " + std::to_string(query));
            const SurfacePoint a = randomPoint();
            const SurfacePoint b = randomPoint();
            const std::optional<StripSearch::Way> way = search.find(a, b);
            const double least = leastCost(surface_, costs, a, b);
            if (!way) {
                EXPECT_EQ(least, kNever);
                continue;
            }
            EXPECT_TRUE(way->overPatches.empty());
            for (const int f : way->strip) {
                EXPECT_TRUE(std::isfinite(costs[f])) << "face " << f;
            }
            if (way->strip.size() > 1) {
                // Sums of at most a hundred legs, in another order.
                EXPECT_NEAR(costOf(surface_, way->strip, costs, a, b), least, 1e-12 * least);
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, StripsOfLeastCost, testing::Values(1, 2, 3));

class PatchWays : public testing::Test {
protected:
    Surface surface_{icosphere(6)};
    PatchLevels patches_{surface_};
    TravelCosts even_;
    CorridorSearch search_{surface_, patches_, even_};
    SurfacePoint start_{17, {0.2, 0.3, 0.5}};
    SurfacePoint goal_{surface_.faceCount() - 5, {0.2, 0.3, 0.5}};
};

TEST_F(PatchWays, LeadOverPatchesThatTouch) {
    // More than lie on the way at the level above.
    constexpr int kMany = 50;
    ASSERT_EQ(search_.find(start_, goal_, kMany), CorridorSearch::Found::LongWay);
    std::vector<SurfacePoint> way = search_.pointsOnWay();
    way.insert(way.begin(), start_);
    way.push_back(goal_);
    EXPECT_GT(way.size(), kMany);
    double length = 0.0;
    for (std::size_t i = 1; i < way.size(); ++i) {
        const double leg = (surface_.position(way[i]) - surface_.position(way[i - 1])).norm();
        EXPECT_LT(leg, 0.2);
        length += leg;
    }
    const double shortest = std::acos(
        surface_.position(start_).normalized().dot(surface_.position(goal_).normalized())
    );
    EXPECT_GT(length, 0.99 * shortest);
    EXPECT_LT(length, 1.4 * shortest);
}

TEST_F(PatchWays, LeaveACorridorWhereTheyAreShort) {
    const SurfacePoint near{surface_.faceNeighbours()[17][0], {0.2, 0.3, 0.5}};
    EXPECT_EQ(search_.find(start_, near, 11), CorridorSearch::Found::Corridor);
    EXPECT_TRUE(search_.holds(start_.face));
    EXPECT_TRUE(search_.holds(near.face));
    EXPECT_EQ(search_.find(start_, goal_), CorridorSearch::Found::Corridor);
    EXPECT_TRUE(search_.holds(goal_.face));
}

}  // namespace
}  // namespace bspline_curve
