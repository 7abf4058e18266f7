// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/self_intersection.h"

#include "exact_oracle.h"
#include "support/meshes.h"
#include "support/random.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <string>

namespace bspline_curve {
namespace {

using exact_oracle::Point;
using namespace test_support;
using PairList = std::vector<std::pair<int, int>>;

TEST(TrianglesIntersect, SeesWhetherTrianglesWithoutSharedCornersMeet) {
    struct Case {
        std::string name;
        bool meet;
        std::vector<Vec3> first, second;
    };

    const double tiny = 0x1p-50;
    const std::vector<Vec3> base = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
    const Case cases[] = {
        {"piercing", true, base, {{1, 1, -1}, {1, 1, 1}, {2, 1, 1}}},
        {"parallel", false, base, {{0, 0, tiny}, {4, 0, tiny}, {0, 4, tiny}}},
        {"inside", true, {{0, 0, 0}, {9, 0, 0}, {0, 9, 0}}, {{1, 1, 0}, {2, 1, 0}, {1, 2, 0}}},
        {"coplanar overlap without a corner inside",
         true,
         {{0, 0, 0}, {6, 0, 0}, {3, 5, 0}},
         {{0, 3, 0}, {3, -2, 0}, {6, 3, 0}}},
        {"coplanar and apart", false, base, {{4, 1, 0}, {4, 4, 0}, {1, 4, 0}}},
        {"corner on corner", true, base, {{4, 0, 0}, {5, 0, 1}, {5, 1, 1}}},
        {"corner on edge", true, base, {{2, 2, 0}, {3, 3, 1}, {3, 4, 1}}},
        {"corner inside", true, base, {{1, 1, 0}, {3, 3, 1}, {3, 4, 1}}},
        {"edge on edge", true, base, {{2, -1, -1}, {2, 1, 1}, {2, -3, 3}}},
        {"neighbours of a flat grid, unwelded",
         true,
         {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
         {{1, 0, 0}, {1, 1, 0}, {0, 1, 0}}},
    };
    for (const auto& [name, meet, first, second] : cases) {
        SCOPED_TRACE(name);
        std::vector<Vec3> vertices = first;
        vertices.insert(vertices.end(), second.begin(), second.end());
        EXPECT_EQ(trianglesIntersect(vertices, {0, 1, 2}, {3, 4, 5}), meet);
        EXPECT_EQ(trianglesIntersect(vertices, {3, 4, 5}, {0, 1, 2}), meet);
    }
}

TEST(TrianglesIntersect, LetsTrianglesShareACorner) {
    const std::vector<Vec3> apart = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {-2, 0, 1}, {0, -2, 1}};
    EXPECT_FALSE(trianglesIntersect(apart, {0, 1, 2}, {0, 3, 4}));
    EXPECT_FALSE(trianglesIntersect(apart, {1, 2, 0}, {4, 0, 3}));
    const std::vector<Vec3> piercing = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {1, 1, -1}, {1, 1, 2}};
    EXPECT_TRUE(trianglesIntersect(piercing, {0, 1, 2}, {0, 3, 4}));
    EXPECT_TRUE(trianglesIntersect(piercing, {1, 2, 0}, {4, 0, 3}));
}

TEST(TrianglesIntersect, LetsTrianglesShareAnEdgeUnlessFoldedFlat) {
    const std::vector<Vec3> vertices = {
        {0, 0, 0},
        {2, 0, 0},
        {0, 2, 0},
        {1, -1, 0},
        {1, 1, 1},
        {1, 5, 0},
        {1, 5, 0x1p-60},
        {1, 5, -0x1p-60}
    };
    EXPECT_FALSE(trianglesIntersect(vertices, {0, 1, 2}, {1, 0, 3})) << "flat";
    EXPECT_FALSE(trianglesIntersect(vertices, {0, 1, 2}, {1, 0, 4})) << "bent";
    EXPECT_TRUE(trianglesIntersect(vertices, {0, 1, 2}, {1, 0, 5})) << "folded onto it";
    EXPECT_FALSE(trianglesIntersect(vertices, {0, 1, 2}, {1, 0, 6})) << "folded almost onto it";
    EXPECT_FALSE(trianglesIntersect(vertices, {0, 1, 2}, {1, 0, 7})) << "folded almost onto it";
}

TEST(TrianglesIntersect, RefusesTrianglesWithTheSameVertices) {
    const std::vector<Vec3> vertices = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}};
    EXPECT_TRUE(trianglesIntersect(vertices, {0, 1, 2}, {0, 1, 2}));
    EXPECT_TRUE(trianglesIntersect(vertices, {0, 1, 2}, {2, 1, 0}));
}

struct OracleCase {
    int sharedCorners;
    int largestCoordinate;
};

class TrianglesIntersectOracle : public ::testing::TestWithParam<OracleCase> {};

bool hasArea(const std::array<Point, 3>& t) {
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t x = (k + 1) % 3;
        const std::size_t y = (k + 2) % 3;
        if ((t[1][x] - t[0][x]) * (t[2][y] - t[0][y]) !=
            (t[1][y] - t[0][y]) * (t[2][x] - t[0][x])) {
            return true;
        }
    }
    return false;
}

/// Two random triangles with area, whose leading corners are shared.
std::array<std::array<Point, 3>, 2> randomTriangles(
    Random& random, int sharedCorners, int largestCoordinate
) {
    const auto coordinate = [&] { return std::int64_t{random.integer(0, largestCoordinate)}; };
    std::array<std::array<Point, 3>, 2> t{};
    do {
        for (auto& triangle : t) {
            for (Point& point : triangle) {
                point = {coordinate(), coordinate(), coordinate()};
            }
        }
        std::copy_n(t[0].begin(), sharedCorners, t[1].begin());
    } while (!hasArea(t[0]) || !hasArea(t[1]));
    return t;
}

/// Compares with the expected answer in every order of the corners and of the triangles.
void expectInEveryOrder(
    const std::vector<Vec3>& vertices, Triangle first, Triangle second, bool expected
) {
    std::ranges::sort(first);
    do {
        std::ranges::sort(second);
        do {
            EXPECT_EQ(trianglesIntersect(vertices, first, second), expected);
            EXPECT_EQ(trianglesIntersect(vertices, second, first), expected);
        } while (std::ranges::next_permutation(second).found);
    } while (std::ranges::next_permutation(first).found);
}

TEST_P(TrianglesIntersectOracle, AgreesWithExactLinearProgrammingOnSmallIntegers) {
    const auto [sharedCorners, largestCoordinate] = GetParam();
    const int seed = 10 + 6 * sharedCorners + largestCoordinate;
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(static_cast<std::uint64_t>(seed));
    constexpr int kCases = 2000;
    int meeting = 0;
    for (int i = 0; i < kCases && !HasFailure(); ++i) {
        SCOPED_TRACE("case " + std::to_string(i));
        const auto t = randomTriangles(random, sharedCorners, largestCoordinate);
        const bool expected = exact_oracle::trianglesMeet(t[0], t[1], sharedCorners);
        meeting += expected ? 1 : 0;

        // Every other one far from the origin. Vertices 0-2 are the first triangle's.
        const double offset = i % 2 == 0 ? 0.0 : 0x1p30;
        std::vector<Vec3> vertices;
        for (const auto& triangle : t) {
            for (const auto& [x, y, z] : triangle) {
                const auto place = [&](std::int64_t c) { return offset + static_cast<double>(c); };
                vertices.emplace_back(place(x), place(y), place(z));
            }
        }
        Triangle second = {3, 4, 5};
        std::iota(second.begin(), second.begin() + sharedCorners, 0);
        expectInEveryOrder(vertices, {0, 1, 2}, second, expected);
    }
    EXPECT_GT(meeting, kCases / 50);
    EXPECT_LT(meeting, kCases - kCases / 50);
}

INSTANTIATE_TEST_SUITE_P(
    SharedCornersAndSize,
    TrianglesIntersectOracle,
    ::testing::Values(
        OracleCase{0, 1},
        OracleCase{0, 2},
        OracleCase{0, 5},
        OracleCase{1, 1},
        OracleCase{1, 2},
        OracleCase{1, 4},
        OracleCase{2, 1},
        OracleCase{2, 2}
    ),
    [](const auto& testCase) {
        return "Shared" + std::to_string(testCase.param.sharedCorners) + "Up" +
               std::to_string(testCase.param.largestCoordinate);
    }
);

PairList bruteForce(const TriangleMesh& mesh) {
    PairList pairs;
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
        for (std::size_t j = i + 1; j < mesh.faces.size(); ++j) {
            if (trianglesIntersect(mesh.vertices, mesh.faces[i], mesh.faces[j])) {
                pairs.emplace_back(i, j);
            }
        }
    }
    return pairs;
}

TEST(FindSelfIntersections, FindsNothingInCleanMeshes) {
    for (const TriangleMesh& mesh :
         {plate(9, 7),
          jitteredPlate(12, 12, 0.25, 1),
          openCylinder(24, 6),
          icosphere(3),
          torus(30, 14),
          box(4),
          twoComponents()}) {
        EXPECT_TRUE(findSelfIntersections(mesh.vertices, mesh.faces).empty());
    }
}

TEST(FindSelfIntersections, FindsTheSamePairsAsBruteForce) {
    const TriangleMesh crossing = crossingPlates();
    const PairList expected = bruteForce(crossing);
    EXPECT_FALSE(expected.empty());
    EXPECT_EQ(findSelfIntersections(crossing.vertices, crossing.faces), expected);

    for (const std::uint64_t seed : {4U, 5U, 6U}) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const TriangleMesh crumpled = withNoise(icosphere(2), 0.2, seed);
        const PairList pairs = bruteForce(crumpled);
        EXPECT_FALSE(pairs.empty());
        EXPECT_EQ(findSelfIntersections(crumpled.vertices, crumpled.faces), pairs);
    }
}

TEST(FindSelfIntersections, HandlesEmptyAndTinySets) {
    EXPECT_TRUE(findSelfIntersections({}, {}).empty());
    const TriangleMesh one = plate(1, 1);
    EXPECT_TRUE(findSelfIntersections(one.vertices, {one.faces[0]}).empty());
    EXPECT_TRUE(findSelfIntersections(one.vertices, one.faces).empty());
}

TEST(FindSelfIntersections, FindsDuplicatesOfOneFaceEvenWhenAllCentresCoincide) {
    const TriangleMesh one = plate(1, 1);
    const std::vector<Triangle> copies(9, one.faces[0]);
    EXPECT_EQ(findSelfIntersections(one.vertices, copies).size(), 9U * 8U / 2U);
}

}  // namespace
}  // namespace bspline_curve
