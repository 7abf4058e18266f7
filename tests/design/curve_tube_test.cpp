// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/curve_tube.h"

#include "support/orientation.h"
#include "support/random.h"
#include "surface/surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr int kSides = 12;
/// Of the area of a circle: that of its regular polygon.
const double kPolygonArea = kSides / kTurn * std::sin(kTurn / kSides);

std::vector<Vec3> pointsOf(int count, const std::function<Vec3(double)>& curve) {
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i) {
        points.push_back(curve(static_cast<double>(i) / count));
    }
    return points;
}

Vec3 circle(double t) {
    return {std::cos(kTurn * t), std::sin(kTurn * t), 0.0};
}

/// A knot on a torus, whose parallel transport does not close.
Vec3 knot(double t) {
    const double r = 1.0 + 0.4 * std::cos(3.0 * kTurn * t);
    return {
        r * std::cos(2.0 * kTurn * t),
        r * std::sin(2.0 * kTurn * t),
        0.4 * std::sin(3.0 * kTurn * t)
    };
}

/// Every edge has two faces, one on either side.
void expectWatertight(const TriangleMesh& tube) {
    std::map<std::pair<int, int>, int> edges;
    for (const Triangle& face : tube.faces) {
        for (std::size_t k = 0; k < 3; ++k) {
            ++edges[{face[k], face[(k + 1) % 3]}];
        }
    }
    for (const auto& [edge, count] : edges) {
        EXPECT_EQ(count, 1);
        EXPECT_TRUE(edges.contains({edge.second, edge.first}));
    }
    for (const Vec3& vertex : tube.vertices) {
        EXPECT_TRUE(vertex.allFinite());
    }
}

TEST(CurveTube, AroundASegmentIsAPrismWithLids) {
    const std::vector<Vec3> points = {{1.0, 2.0, 3.0}, {1.0, 2.0, 8.0}};
    const TriangleMesh tube = makeTube(points, false, 0.5);
    expectWatertight(tube);
    EXPECT_EQ(tube.vertices.size(), 2u * kSides + 2u);
    EXPECT_NEAR(volumeOf(tube), kPolygonArea * std::numbers::pi * 0.25 * 5.0, 1e-12);
    EXPECT_NO_THROW(Surface{tube});
}

TEST(CurveTube, AroundACircleIsATorusOfTheRightVolume) {
    const TriangleMesh tube = makeTube(pointsOf(400, circle), true, 0.1);
    expectWatertight(tube);
    const Surface surface(tube);
    EXPECT_EQ(surface.vertexCount() - surface.faceCount() * 3 / 2 + surface.faceCount(), 0)
        << "the Euler characteristic of a torus";
    const double expected = kPolygonArea * std::numbers::pi * 0.01 * kTurn;
    EXPECT_NEAR(volumeOf(tube), expected, 0.002 * expected);
}

TEST(CurveTube, LiesOneRadiusFromTheCurve) {
    const std::vector<Vec3> points = pointsOf(500, knot);
    for (const Vec3& vertex : makeTube(points, true, 0.02).vertices) {
        double nearest = 1.0;
        for (const Vec3& point : points) {
            nearest = std::min(nearest, (vertex - point).norm());
        }
        EXPECT_NEAR(nearest, 0.02, 1e-4);
    }
}

TEST(CurveTube, OfAClosedCurveHasNoSeam) {
    const std::vector<Vec3> points = pointsOf(300, knot);
    const TriangleMesh tube = makeTube(points, true, 0.05);
    expectWatertight(tube);
    EXPECT_NO_THROW(Surface{tube});
    // A seam would turn one ring against the next by more than the others.
    const std::size_t rings = tube.vertices.size() / kSides;
    const auto spoke = [&](std::size_t ring) {
        Vec3 sum = Vec3::Zero();
        for (std::size_t j = 0; j < kSides; ++j) {
            sum += tube.vertices[ring * kSides + j];
        }
        return Vec3(tube.vertices[ring * kSides] - sum / kSides);
    };
    std::vector<double> turns;
    for (std::size_t i = 0; i < rings; ++i) {
        turns.push_back((spoke(i) - spoke((i + 1) % rings)).norm());
    }
    std::vector<double> sorted = turns;
    std::ranges::sort(sorted);
    EXPECT_LT(turns.back(), 2.0 * sorted[rings / 2]);
    EXPECT_LT(sorted.back(), 0.02);
}

TEST(CurveTube, IsWholeAtSharpKinks) {
    const Vec3 corner(1.0, 0.0, 0.0);
    for (const double angle : {90.0, 150.0, 179.0, 179.9999999, 180.0}) {
        const double turn = angle / 360.0 * kTurn;
        const Vec3 end = corner + Vec3(std::cos(turn), std::sin(turn), 0.0);
        const std::vector<Vec3> points = {{0.0, 0.0, 0.0}, corner, end};
        expectWatertight(makeTube(points, false, 0.1));
        expectWatertight(makeTube(points, true, 0.1));
    }
}

TEST(CurveTube, IsWholeAroundRandomPolylines) {
    constexpr std::uint64_t kSeed = 20260101;
    SCOPED_TRACE("seed " + std::to_string(kSeed));
    Random random(kSeed);
    for (int round = 0; round < 200; ++round) {
        std::vector<Vec3> points;
        for (int i = 0; i < 3 + round % 17; ++i) {
            points.push_back(random.point(-1.0, 1.0));
        }
        const double radius = std::pow(10.0, random.uniform(-6.0, 1.0));
        expectWatertight(makeTube(points, round % 2 == 0, radius));
    }
}

TEST(CurveTube, HasFewRingsAroundManyShortSegments) {
    const std::vector<Vec3> points = pointsOf(20000, circle);
    const TriangleMesh tube = makeTube(points, true, 0.1);
    EXPECT_LT(tube.vertices.size(), kSides * kTurn / 0.024);
    EXPECT_GT(tube.vertices.size(), kSides * kTurn / 0.027);
    expectWatertight(tube);
}

TEST(CurveTube, KeepsBothEndsOfAShortCurve) {
    const std::vector<Vec3> points = {
        {0.0, 0.0, 0.0}, {1e-9, 0.0, 0.0}, {0.5, 0.0, 0.0}, {0.5 + 1e-9, 0.0, 0.0}
    };
    for (const double radius : {0.01, 1.0, 100.0}) {
        const TriangleMesh tube = makeTube(points, false, radius);
        expectWatertight(tube);
        EXPECT_EQ(tube.vertices[tube.vertices.size() - 2], points.front());
        EXPECT_EQ(tube.vertices.back(), points.back());
    }
}

TEST(CurveTube, ScalesWithTheCurve) {
    const std::vector<Vec3> points = pointsOf(100, knot);
    const std::vector<Vec3> larger = pointsOf(100, [](double t) { return Vec3(1024.0 * knot(t)); });
    const TriangleMesh tube = makeTube(points, true, 0.05);
    const TriangleMesh large = makeTube(larger, true, 0.05 * 1024.0);
    ASSERT_EQ(tube.faces, large.faces);
    for (std::size_t i = 0; i < tube.vertices.size(); ++i) {
        EXPECT_LT((1024.0 * tube.vertices[i] - large.vertices[i]).norm(), 1e-10);
    }
}

}  // namespace
}  // namespace bspline_curve
