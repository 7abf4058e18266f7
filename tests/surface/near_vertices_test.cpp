// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/near_vertices.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace bspline_curve {
namespace {

std::vector<int> setsOf(const std::vector<Vec3>& vertices, double distance) {
    return nearVertices(vertices, distance).numbered().first;
}

TEST(NearVertices, AreJoinedStepByStep) {
    const std::vector<Vec3> row = {{0, 0, 0}, {5, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1.5, 0}};
    EXPECT_EQ(setsOf(row, 1.0), (std::vector<int>{0, 1, 0, 0, 2}));
    EXPECT_EQ(setsOf(row, 1.5), (std::vector<int>{0, 1, 0, 0, 0}));
}

TEST(NearVertices, AtOnePlaceAreOneAtAnyDistance) {
    for (const double distance : {0.0, std::numeric_limits<double>::denorm_min(), 1.0}) {
        EXPECT_EQ(setsOf({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}, distance), std::vector<int>(3, 0));
    }
    EXPECT_TRUE(setsOf({}, 0.0).empty());
}

TEST(NearVertices, AreToldApartByTinyDistances) {
    const double above = std::nextafter(1.0, 2.0);
    const std::vector<Vec3> three = {{1, 0, 0}, {above, 0, 0}, {1, 0, 0}};
    for (const double distance : {0.0, std::numeric_limits<double>::denorm_min()}) {
        EXPECT_EQ(setsOf(three, distance), (std::vector<int>{0, 1, 0}));
    }
    EXPECT_EQ(setsOf(three, above - 1.0), std::vector<int>(3, 0));
}

// Their distance is 0 in doubles.
TEST(NearVertices, MayBeApartByTheLeastNumber) {
    const double least = std::numeric_limits<double>::denorm_min();
    EXPECT_EQ(setsOf({{0, 0, 0}, {least, 0, 0}}, 0.0), std::vector<int>(2, 0));
}

// Pair by pair this would take minutes.
TEST(NearVertices, MayBeManyAtOnePlace) {
    std::vector<Vec3> vertices(300000, Vec3(0.5, 0.5, 0.5));
    vertices.emplace_back(0.0, 0.0, 0.0);
    std::vector<int> expected(vertices.size(), 0);
    expected.back() = 1;
    EXPECT_EQ(setsOf(vertices, 0.1), expected);
}

}  // namespace
}  // namespace bspline_curve
