// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/geodesic_path.h"

#include "support/meshes.h"
#include "support/random.h"
#include "surface/closest_point.h"
#include "surface/strip_unfolding.h"
#include "surface/surface_point.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <utility>

namespace bspline_curve {
namespace {

using namespace test_support;

SurfacePoint randomPoint(const Surface& surface, Random& random) {
    const double a = random.uniform(0.0, 1.0);
    const double b = random.uniform(0.0, 1.0 - a);
    const int face = random.integer(0, surface.faceCount() - 1);
    return {face, {a, b, 1.0 - a - b}};
}

// A point inside a face, at its vertex, or on its edge.
SurfacePoint randomPointOfAnyKind(const Surface& surface, Random& random) {
    SurfacePoint point = randomPoint(surface, random);
    const int kind = random.integer(0, 3);
    if (kind == 0) {
        point.barycentric = Vec3::Unit(random.integer(0, 2));
    } else if (kind == 1) {
        point.barycentric[random.integer(0, 2)] = 0.0;
        point.barycentric /= point.barycentric.sum();
    }
    return point;
}

SurfacePoint atVertex(const Surface& surface, int vertex) {
    const int face = *surface.facesAround(vertex).begin();
    return {face, Vec3::Unit(cornerOf(surface.faces()[face], vertex))};
}

Vec3 randomInRectangle(Random& random, double x0, double x1, double y0, double y1) {
    const double x = random.uniform(x0, x1);
    const double y = random.uniform(y0, y1);
    return {x, y, 0.0};
}

// The point of a surface nearest to a position.
SurfacePoint locate(const Surface& surface, const Vec3& p) {
    SurfacePoint best;
    double least = std::numeric_limits<double>::infinity();
    for (int f = 0; f < surface.faceCount(); ++f) {
        const ClosestPointOnTriangle closest =
            closestPointOnTriangle(surface.vertices(), surface.faces()[f], p);
        if (closest.squaredDistance < least) {
            least = closest.squaredDistance;
            best = {f, closest.barycentric};
        }
    }
    return best;
}

void expectWellFormed(
    const Surface& surface, const GeodesicPath& path, const SurfacePoint& a, const SurfacePoint& b
) {
    ASSERT_EQ(path.points.size(), path.positions.size());
    ASSERT_GE(path.points.size(), 2U);
    EXPECT_LT((path.positions.front() - surface.position(a)).norm(), 1e-14);
    EXPECT_LT((path.positions.back() - surface.position(b)).norm(), 1e-14);
    double length = 0.0;
    for (std::size_t i = 0; i < path.points.size(); ++i) {
        EXPECT_LT((surface.position(path.points[i]) - path.positions[i]).norm(), 1e-14);
        EXPECT_GE(path.points[i].barycentric.minCoeff(), 0.0) << "point " << i;
        if (i > 0) {
            length += (path.positions[i] - path.positions[i - 1]).norm();
            EXPECT_GE(commonFace(surface, path.points[i - 1], path.points[i]), 0)
                << "segment " << i - 1 << " of " << path.points.size() - 1;
        }
    }
    EXPECT_NEAR(path.length, length, 1e-13 * (1.0 + length));
}

TravelCosts travelCosts(const std::vector<double>& costs) {
    return {[costs](int face) { return costs[face]; }, *std::ranges::min_element(costs)};
}

// Costs that let paths enter all faces but those with a flag.
TravelCosts costsAround(const std::vector<char>& blocked) {
    if (blocked.empty()) {
        return {};
    }
    std::vector<double> costs;
    for (const char flag : blocked) {
        costs.push_back(flag != 0 ? std::numeric_limits<double>::infinity() : 1.0);
    }
    return travelCosts(costs);
}

GeodesicPath goodPath(
    const Surface& surface,
    const SurfacePoint& a,
    const SurfacePoint& b,
    const std::vector<char>& blocked = {}
) {
    GeodesicPathFinder finder(surface, costsAround(blocked));
    const std::optional<GeodesicPath> path = finder.find(a, b);
    if (!path) {
        ADD_FAILURE() << "no path";
        return {};
    }
    expectWellFormed(surface, *path, a, b);
    return *path;
}

void expectSegmentsOnAPlane(const Surface& surface, std::uint64_t seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    for (int i = 0; i < 300; ++i) {
        SCOPED_TRACE("pair " + std::to_string(i));
        const SurfacePoint a = randomPointOfAnyKind(surface, random);
        const SurfacePoint b = randomPointOfAnyKind(surface, random);
        const GeodesicPath path = goodPath(surface, a, b);
        const double distance = (surface.position(a) - surface.position(b)).norm();
        EXPECT_NEAR(path.length, distance, 1e-12 * distance);
    }
}

TEST(GeodesicPaths, AreSegmentsOnAPlate) {
    expectSegmentsOnAPlane(Surface(plate(13, 9)), 1);
    expectSegmentsOnAPlane(Surface(plate(1, 1)), 2);
    expectSegmentsOnAPlane(Surface(plate(40, 2, 4.0, 0.5)), 3);
}

TEST(GeodesicPaths, AreSegmentsOnAJitteredPlate) {
    for (const std::uint64_t seed : {4U, 5U, 6U}) {
        expectSegmentsOnAPlane(Surface(jitteredPlate(12, 12, 0.29, seed)), seed);
    }
}

TEST(GeodesicPaths, AreUnfoldedSegmentsAcrossTheEdgeOfABox) {
    const Surface surface(box(7, {1.0, 1.0, 1.0}));
    Random random(8);
    for (int i = 0; i < 100; ++i) {
        SCOPED_TRACE("seed 8, pair " + std::to_string(i));
        // From the top z = 1 to the side x = 1, near enough to their edge that no way over a third
        // side is shorter.
        const Vec3 a = randomInRectangle(random, 0.8, 1.0, 0.35, 0.65) + Vec3::UnitZ();
        const Vec3 side = randomInRectangle(random, 0.8, 1.0, 0.35, 0.65);
        const Vec3 b(1.0, side.y(), side.x());
        const GeodesicPath path = goodPath(surface, locate(surface, a), locate(surface, b));
        const double expected = std::hypot(a.y() - b.y(), (1.0 - a.x()) + (1.0 - b.z()));
        EXPECT_NEAR(path.length, expected, 1e-12);
    }
}

TEST(GeodesicPaths, AreHelicesOnACylinder) {
    constexpr int kSegments = 24;
    const Surface surface(openCylinder(kSegments, 20, 1.0, 3.0));
    const double side = 2.0 * std::sin(std::numbers::pi / kSegments);
    // The point of the prism `s` sides round and z up.
    const auto onCylinder = [&](double s, double z) {
        const int i = static_cast<int>(std::floor(s));
        const auto corner = [](int k) {
            const double angle = 2.0 * std::numbers::pi * k / kSegments;
            return Vec3(std::cos(angle), std::sin(angle), 0.0);
        };
        return Vec3((1.0 - (s - i)) * corner(i) + (s - i) * corner(i + 1) + Vec3(0.0, 0.0, z));
    };
    Random random(9);
    for (int i = 0; i < 100; ++i) {
        SCOPED_TRACE("seed 9, pair " + std::to_string(i));
        const double s = random.uniform(0.0, 24.0);
        const double round = random.uniform(-8.0, 8.0);
        const double z0 = random.uniform(0.1, 2.9);
        const double z1 = random.uniform(0.1, 2.9);
        const GeodesicPath path = goodPath(
            surface,
            locate(surface, onCylinder(s, z0)),
            locate(surface, onCylinder(s + round + kSegments, z1))
        );
        EXPECT_NEAR(path.length, std::hypot(side * round, z1 - z0), 1e-12);
    }
}

// A box with sides of needles from bottom to top: its corners lie on the sides of a square of
// length 2, moved by a factor for each. The lids are fans round their middles.
TriangleMesh needleBox(int corners, double height, const std::function<double()>& factor) {
    TriangleMesh mesh;
    for (const double z : {0.0, height}) {
        for (int i = 0; i < corners; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / corners;
            const Vec3 direction(std::cos(angle), std::sin(angle), 0.0);
            const double radius = factor() / direction.cwiseAbs().maxCoeff();
            mesh.vertices.emplace_back(radius * direction + Vec3(0.0, 0.0, z));
        }
    }
    mesh.vertices.emplace_back(0.0, 0.0, 0.0);
    mesh.vertices.emplace_back(0.0, 0.0, height);
    for (int i = 0; i < corners; ++i) {
        const int next = (i + 1) % corners;
        mesh.faces.push_back({i, next, corners + i});
        mesh.faces.push_back({next, corners + next, corners + i});
        mesh.faces.push_back({2 * corners, next, i});
        mesh.faces.push_back({2 * corners + 1, corners + i, corners + next});
    }
    return mesh;
}

// From one side of the box to the next. Straight ways over the lid are shortest in their strips,
// and over midpoints of edges much shorter than all over the sides.
TEST(GeodesicPaths, AcrossNeedlesAreStraight) {
    const Surface surface(needleBox(64, 20.0, [] { return 1.0; }));
    Random random(30);
    for (int i = 0; i < 20; ++i) {
        const double u = random.uniform(0.3, 0.9);
        const double v = random.uniform(0.3, 0.9);
        const GeodesicPath path = goodPath(
            surface, locate(surface, {1.0, 1.0 - u, 19.4}), locate(surface, {1.0 - v, 1.0, 19.4})
        );
        EXPECT_NEAR(path.length, u + v, 1e-12) << "pair " << i;
    }
}

// The length of the shortest way over points at even steps on edges, within faces: longer than the
// shortest path. A vertex stands there once for each of its edges.
double lengthOverSteps(
    const Surface& surface, const SurfacePoint& start, const SurfacePoint& goal, int steps
) {
    std::map<std::pair<int, int>, std::vector<int>> onEdge;
    std::vector<Vec3> nodes;
    std::vector<std::vector<int>> ofFace(surface.faceCount());
    for (int f = 0; f < surface.faceCount(); ++f) {
        for (int k = 0; k < 3; ++k) {
            const auto [a, b] = std::minmax(surface.faces()[f][k], surface.faces()[f][(k + 1) % 3]);
            std::vector<int>& on = onEdge[{a, b}];
            for (int i = 0; on.size() <= static_cast<std::size_t>(steps); ++i) {
                const double share = static_cast<double>(i) / steps;
                on.push_back(static_cast<int>(nodes.size()));
                nodes.emplace_back(
                    (1.0 - share) * surface.vertices()[a] + share * surface.vertices()[b]
                );
            }
            ofFace[f].insert(ofFace[f].end(), on.begin(), on.end());
        }
    }
    for (const SurfacePoint& end : {start, goal}) {
        for (const int f : facesHolding(surface, end)) {
            ofFace[f].push_back(static_cast<int>(nodes.size()));
        }
        nodes.push_back(surface.position(end));
    }
    std::vector<std::vector<int>> facesOf(nodes.size());
    for (int f = 0; f < surface.faceCount(); ++f) {
        for (const int node : ofFace[f]) {
            facesOf[node].push_back(f);
        }
    }
    std::vector<double> lengths(nodes.size(), std::numeric_limits<double>::infinity());
    std::set<std::pair<double, int>> open{{0.0, static_cast<int>(nodes.size()) - 2}};
    lengths[nodes.size() - 2] = 0.0;
    while (!open.empty()) {
        const auto [length, node] = *open.begin();
        open.erase(open.begin());
        for (const int f : facesOf[node]) {
            for (const int next : ofFace[f]) {
                const double there = length + (nodes[next] - nodes[node]).norm();
                if (there < lengths[next]) {
                    open.erase({lengths[next], next});
                    lengths[next] = there;
                    open.insert({there, next});
                }
            }
        }
    }
    return lengths.back();
}

TEST(GeodesicPaths, OverRandomNeedlesAreNoDetours) {
    for (const std::uint64_t seed : {30U, 31U, 32U}) {
        Random random(seed);
        const Surface surface(
            renumbered(needleBox(40, 5.0, [&] { return random.uniform(0.9, 1.1); }), seed)
        );
        for (int i = 0; i < 8; ++i) {
            const SurfacePoint a = randomPointOfAnyKind(surface, random);
            const SurfacePoint b = randomPointOfAnyKind(surface, random);
            EXPECT_LE(goodPath(surface, a, b).length, kDetour * lengthOverSteps(surface, a, b, 32))
                << "seed " << seed << ", pair " << i;
        }
    }
}

TEST(GeodesicPaths, InOneFaceAreSegments) {
    const Surface surface(plate(2, 2));
    const SurfacePoint a{3, {0.2, 0.3, 0.5}};
    const SurfacePoint b{3, {0.6, 0.3, 0.1}};
    EXPECT_EQ(goodPath(surface, a, b).points.size(), 2U);
    const GeodesicPath same = goodPath(surface, a, a);
    EXPECT_EQ(same.length, 0.0);
}

TEST(GeodesicPaths, AlongAnEdgeAreTheEdge) {
    const Surface surface(withNoise(icosphere(2), 0.02, 4));
    for (int f = 0; f < 50; ++f) {
        const Triangle& face = surface.faces()[f];
        const GeodesicPath path =
            goodPath(surface, atVertex(surface, face[0]), atVertex(surface, face[1]));
        const double edge = (surface.vertices()[face[0]] - surface.vertices()[face[1]]).norm();
        EXPECT_NEAR(path.length, edge, 1e-14);
    }
}

// Flags for faces whose centres lie in a part of a mesh.
template <class Part>
std::vector<char> facesIn(const Surface& surface, const Part& part) {
    std::vector<char> flags;
    for (int f = 0; f < surface.faceCount(); ++f) {
        flags.push_back(part(surface.position({f, Vec3::Constant(1.0 / 3.0)})) ? 1 : 0);
    }
    return flags;
}

bool inSlot(const Vec3& p) {
    return std::abs(p.x() - 0.5) < 0.1 && p.y() < 0.6;
}

// Round the end of the slot [0.4, 0.6] x [0, 0.6]: two corners.
double lengthRoundTheSlot(const Vec3& a, const Vec3& b) {
    const Vec3 left(0.4, 0.6, 0);
    const Vec3 right(0.6, 0.6, 0);
    return (a - left).norm() + (left - right).norm() + (right - b).norm();
}

void expectWaysRoundTheSlot(
    const Surface& surface, std::uint64_t seed, const std::vector<char>& blocked = {}
) {
    Random random(seed);
    for (int i = 0; i < 300; ++i) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", pair " + std::to_string(i));
        const Vec3 a = randomInRectangle(random, 0.0, 0.4, 0.0, 0.6);
        const Vec3 b = randomInRectangle(random, 0.6, 1.0, 0.0, 0.6);
        const GeodesicPath path =
            goodPath(surface, locate(surface, a), locate(surface, b), blocked);
        EXPECT_NEAR(path.length, lengthRoundTheSlot(a, b), 1e-12);
        for (const SurfacePoint& point : path.points) {
            EXPECT_TRUE(blocked.empty() || blocked[point.face] == 0);
        }
    }
}

TEST(GeodesicPaths, GoRoundBlockedFaces) {
    const Surface surface(plate(10, 10));
    expectWaysRoundTheSlot(surface, 10, facesIn(surface, inSlot));
}

TEST(GeodesicPaths, GoRoundNotches) {
    TriangleMesh mesh = plate(10, 10);
    const std::vector<char> slot = facesIn(Surface(mesh), inSlot);
    const std::vector<Triangle> faces = std::exchange(mesh.faces, {});
    for (std::size_t f = 0; f < faces.size(); ++f) {
        if (slot[f] == 0) {
            mesh.faces.push_back(faces[f]);
        }
    }
    expectWaysRoundTheSlot(Surface(mesh), 11);
}

// The mean cost of a unit of length along the path.
double meanCost(const GeodesicPath& path, const std::vector<double>& costs) {
    double sum = 0.0;
    for (std::size_t i = 1; i < path.points.size(); ++i) {
        sum += costs[path.points[i - 1].face] * (path.positions[i] - path.positions[i - 1]).norm();
    }
    return sum / path.length;
}

// A road along y = 0.75 between places at y = 0.25.
TEST(GeodesicPaths, TakeTheWayRoundWhereThatIsCheaper) {
    const Surface surface(plate(20, 20));
    const std::vector<char> road =
        facesIn(surface, [](const Vec3& p) { return std::abs(p.y() - 0.75) < 0.05; });
    std::vector<double> costs;
    for (const char flag : road) {
        costs.push_back(flag != 0 ? 1.0 : 20.0);
    }
    const SurfacePoint a = locate(surface, {0.1, 0.6, 0});
    const SurfacePoint b = locate(surface, {0.9, 0.6, 0});
    const SurfacePoint near = locate(surface, {0.15, 0.6, 0});
    GeodesicPathFinder finder(surface, travelCosts(costs));
    const std::optional<GeodesicPath> far = finder.find(a, b);
    ASSERT_TRUE(far.has_value());
    expectWellFormed(surface, *far, a, b);
    EXPECT_LT(meanCost(*far, costs), 0.4 * 20.0);  // two ways of 0.1 to the road, 0.8 along it
    EXPECT_GT(far->length, 0.9);
    // Not worth the way.
    const std::optional<GeodesicPath> straight = finder.find(a, near);
    ASSERT_TRUE(straight.has_value());
    EXPECT_NEAR(straight->length, 0.05, 1e-12);
}

TEST(GeodesicPaths, AreTheSameWhateverAllFacesCost) {
    const Surface surface(withNoise(icosphere(3), 0.02, 4));
    const std::vector<double> costs(surface.faceCount(), 7.5);
    Random random(12);
    for (int i = 0; i < 50; ++i) {
        SCOPED_TRACE("seed 12, pair " + std::to_string(i));
        const SurfacePoint a = randomPointOfAnyKind(surface, random);
        const SurfacePoint b = randomPointOfAnyKind(surface, random);
        GeodesicPathFinder plain(surface, {});
        GeodesicPathFinder costly(surface, travelCosts(costs));
        EXPECT_NEAR(plain.find(a, b)->length, costly.find(a, b)->length, 1e-12);
    }
}

// The strip has a portal along the path, beyond the corner at which it ends.
TEST(GeodesicPaths, DoNotTurnBackOnAnEdgeAlongThem) {
    const Surface surface(plate(10, 10));
    const Vec3 a(0.20629558088616098, 0.45177640581302836, 0);
    const Vec3 b(0.68583887415240341, 0.44601368191699131, 0);
    const GeodesicPath path =
        goodPath(surface, locate(surface, a), locate(surface, b), facesIn(surface, inSlot));
    EXPECT_NEAR(path.length, lengthRoundTheSlot(a, b), 1e-12);
}

TEST(GeodesicPaths, AlongABoundaryAreTheBoundary) {
    const Surface surface(plate(10, 10));
    const Vec3 a(0.03, 0, 0);
    const Vec3 b(0.97, 0, 0);
    EXPECT_NEAR(goodPath(surface, locate(surface, a), locate(surface, b)).length, 0.94, 1e-14);
}

TEST(GeodesicPaths, DoNotExistBetweenComponentsOrBehindBlockedFaces) {
    const Surface spheres(twoComponents());
    GeodesicPathFinder between(spheres, {});
    EXPECT_FALSE(between.find({0, {0.2, 0.3, 0.5}}, {100, {0.2, 0.3, 0.5}}).has_value());
    // The same finder still finds others.
    EXPECT_TRUE(between.find({0, {0.2, 0.3, 0.5}}, {50, {0.2, 0.3, 0.5}}).has_value());

    const Surface surface(plate(10, 10));
    const std::vector<char> wall =
        facesIn(surface, [](const Vec3& p) { return std::abs(p.x() - 0.55) < 0.05; });
    GeodesicPathFinder blocked(surface, costsAround(wall));
    const SurfacePoint left = locate(surface, {0.2, 0.33, 0});
    const SurfacePoint right = locate(surface, {0.8, 0.33, 0});
    const SurfacePoint inside = locate(surface, {0.55, 0.33, 0});
    EXPECT_FALSE(blocked.find(left, right).has_value());
    EXPECT_FALSE(blocked.find(left, inside).has_value());
    EXPECT_FALSE(blocked.find(inside, left).has_value());
    EXPECT_FALSE(blocked.find(inside, inside).has_value());
}

class GeodesicPathsOnNoise : public testing::TestWithParam<std::uint64_t> {
protected:
    Random random_{GetParam()};
    Surface surface_{withNoise(icosphere(3), 0.03, GetParam())};
    testing::ScopedTrace trace_{__FILE__, __LINE__, "seed " + std::to_string(GetParam())};
};

TEST_P(GeodesicPathsOnNoise, AreLocallyShortest) {
    for (int i = 0; i < 100; ++i) {
        SCOPED_TRACE("pair " + std::to_string(i));
        const GeodesicPath path = goodPath(
            surface_,
            randomPointOfAnyKind(surface_, random_),
            randomPointOfAnyKind(surface_, random_)
        );
        for (std::size_t k = 1; k + 1 < path.points.size(); ++k) {
            // Move the crossing along its edge, both ways.
            const SurfacePoint& point = path.points[k];
            const double before = (path.positions[k] - path.positions[k - 1]).norm() +
                                  (path.positions[k + 1] - path.positions[k]).norm();
            Eigen::Index zero = 0;
            point.barycentric.minCoeff(&zero);
            for (const double move : {-0.02, -1e-4, 1e-4, 0.02}) {
                Vec3 barycentric = point.barycentric;
                barycentric[(zero + 1) % 3] += move;
                barycentric[(zero + 2) % 3] -= move;
                if (barycentric.minCoeff() < 0.0) {
                    continue;
                }
                const Vec3 moved = surface_.position({point.face, barycentric});
                const double after =
                    (moved - path.positions[k - 1]).norm() + (path.positions[k + 1] - moved).norm();
                EXPECT_GE(after, before * (1.0 - 1e-12)) << "point " << k << ", moved " << move;
            }
        }
    }
}

TEST_P(GeodesicPathsOnNoise, AreAsLongInReverse) {
    int different = 0;
    for (int i = 0; i < 200; ++i) {
        const SurfacePoint a = randomPointOfAnyKind(surface_, random_);
        const SurfacePoint b = randomPointOfAnyKind(surface_, random_);
        const double forth = goodPath(surface_, a, b).length;
        const double back = goodPath(surface_, b, a).length;
        if (std::abs(forth - back) > 1e-11 * (1.0 + forth)) {
            ++different;
        }
    }
    EXPECT_EQ(different, 0) << "of 200 pairs";
}

TEST_P(GeodesicPathsOnNoise, DoNotDependOnTheQueriesBefore) {
    GeodesicPathFinder finder(surface_, {});
    for (int i = 0; i < 50; ++i) {
        const SurfacePoint a = randomPointOfAnyKind(surface_, random_);
        const SurfacePoint b = randomPointOfAnyKind(surface_, random_);
        const std::optional<GeodesicPath> path = finder.find(a, b);
        ASSERT_TRUE(path.has_value());
        EXPECT_EQ(path->length, goodPath(surface_, a, b).length);
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, GeodesicPathsOnNoise, testing::Values(21, 22, 23));

TEST(StripUnfolding, TurnsAtTheCornersOfTheStrip) {
    // A strip of faces round the slot's end; the path in it bends at two vertices by the angles
    // that the plane says.
    const Surface surface(plate(10, 10));
    const Vec3 a(0.25, 0.25, 0);
    const Vec3 b(0.75, 0.25, 0);
    const GeodesicPath path =
        goodPath(surface, locate(surface, a), locate(surface, b), facesIn(surface, inSlot));
    std::vector<int> strip;
    for (const SurfacePoint& point : path.points) {
        strip.push_back(point.face);
    }
    strip.erase(std::unique(strip.begin(), strip.end()), strip.end());
    const StripPath inStrip = shortestPathInStrip(
        surface,
        strip,
        inFace(surface, path.points.front(), strip.front()),
        inFace(surface, path.points.back(), strip.back())
    );
    ASSERT_EQ(inStrip.corners.size(), 2U);
    const double bend = std::atan2(0.35, 0.15);
    for (const StripPath::Corner& corner : inStrip.corners) {
        EXPECT_NEAR(corner.bend, bend, 1e-12);
        EXPECT_NEAR(surface.vertices()[corner.vertex].y(), 0.6, 1e-15);
    }
    EXPECT_EQ(inStrip.crossings.size(), strip.size() - 1);
    for (const double crossing : inStrip.crossings) {
        EXPECT_GE(crossing, 0.0);
        EXPECT_LE(crossing, 1.0);
    }
}

}  // namespace
}  // namespace bspline_curve
