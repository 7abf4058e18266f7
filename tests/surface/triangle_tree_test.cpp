// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/triangle_tree.h"

#include "support/meshes.h"
#include "support/random.h"
#include "surface/closest_point.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <utility>

namespace bspline_curve {
namespace {

using namespace test_support;

void expectBarycentric(const Vec3& barycentric) {
    EXPECT_GE(barycentric.minCoeff(), 0.0);
    EXPECT_LE(barycentric.maxCoeff(), 1.0);
    EXPECT_NEAR(barycentric.sum(), 1.0, 1e-15);
}

/// The closest point by minimising over a fine grid of barycentric coordinates.
double sampledDistance(const std::vector<Vec3>& corners, const Vec3& query) {
    constexpr int kSteps = 200;
    double best = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= kSteps; ++i) {
        for (int j = 0; i + j <= kSteps; ++j) {
            const double u = static_cast<double>(i) / kSteps;
            const double v = static_cast<double>(j) / kSteps;
            const Vec3 point = (1.0 - u - v) * corners[0] + u * corners[1] + v * corners[2];
            best = std::min(best, (query - point).norm());
        }
    }
    return best;
}

TEST(ClosestPointOnTriangle, FindsCornersEdgesAndTheInterior) {
    const std::vector<Vec3> corners = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
    const std::vector<std::pair<Vec3, Vec3>> queriesAndClosest = {
        {{-1, -2, 3}, {0, 0, 0}},
        {{9, -1, 0}, {4, 0, 0}},
        {{0, 7, 2}, {0, 4, 0}},
        {{1, -2, 1}, {1, 0, 0}},
        {{5, 5, 0}, {2, 2, 0}},
        {{-3, 2, 0}, {0, 2, 0}},
        {{1, 1, 5}, {1, 1, 0}},
    };
    for (const auto& [query, expected] : queriesAndClosest) {
        const ClosestPointOnTriangle closest = closestPointOnTriangle(corners, {0, 1, 2}, query);
        EXPECT_EQ(closest.position, expected);
        EXPECT_EQ(4.0 * closest.barycentric[1], expected[0]);
        EXPECT_EQ(4.0 * closest.barycentric[2], expected[1]);
        EXPECT_DOUBLE_EQ(closest.squaredDistance, (query - expected).squaredNorm());
        expectBarycentric(closest.barycentric);
    }
}

TEST(ClosestPointOnTriangle, IsNeverFartherThanAnySampleOfTheTriangle) {
    SCOPED_TRACE("seed 1");
    Random random(1);
    for (int i = 0; i < 100; ++i) {
        const std::vector<Vec3> corners = {
            random.point(-1.0, 1.0), random.point(-1.0, 1.0), random.point(-1.0, 1.0)
        };
        const Vec3 query = random.point(-2.0, 2.0);
        const ClosestPointOnTriangle closest = closestPointOnTriangle(corners, {0, 1, 2}, query);
        expectBarycentric(closest.barycentric);
        const double distance = std::sqrt(closest.squaredDistance);
        const double sampled = sampledDistance(corners, query);
        EXPECT_LE(distance, sampled + 1e-14) << "case " << i;
        EXPECT_GE(distance, sampled - 0.03) << "case " << i;
        EXPECT_NEAR((query - closest.position).norm(), distance, 1e-15);
    }
}

TEST(ClosestPointOnTriangle, StaysAccurateOnNeedlesAndOnTrianglesWithoutArea) {
    SCOPED_TRACE("seed 2");
    Random random(2);
    for (const double height : {1e-6, 1e-12, 1e-15, 1e-160, 0.0}) {
        for (int i = 0; i < 200; ++i) {
            const Eigen::Isometry3d motion = random.isometry(1.0);
            const std::vector<Vec3> corners = {
                motion * Vec3(0, 0, 0), motion * Vec3(1, 0, 0), motion * Vec3(0.3, height, 0)
            };
            const double along = random.uniform(-0.5, 1.5);
            const double away = random.uniform(0.1, 1.0);
            const Vec3 query = motion * Vec3(along, 0, away);
            const ClosestPointOnTriangle closest =
                closestPointOnTriangle(corners, {0, 1, 2}, query);
            expectBarycentric(closest.barycentric);
            const double beyond = along - std::clamp(along, 0.0, 1.0);
            EXPECT_NEAR(std::sqrt(closest.squaredDistance), std::hypot(beyond, away), 1e-14);
        }
    }
}

TEST(ClosestPointOnTriangle, IsBitwiseTheSameForBothFacesOfAnEdge) {
    SCOPED_TRACE("seed 3");
    Random random(3);
    for (int i = 0; i < 200; ++i) {
        // A ridge: queries above it project to the edge (0, 1) of both faces.
        const Eigen::Isometry3d motion = random.isometry(3.0);
        const std::vector<Vec3> vertices = {
            motion * Vec3(0, 0, 0),
            motion * Vec3(1, 0, 0),
            motion * Vec3(0.4, 1, -2),
            motion * Vec3(0.6, -1, -2)
        };
        const Vec3 query = motion * Vec3(random.uniform(-0.2, 1.2), 0.0, random.uniform(0.1, 1.0));
        const ClosestPointOnTriangle left = closestPointOnTriangle(vertices, {0, 1, 2}, query);
        const ClosestPointOnTriangle right = closestPointOnTriangle(vertices, {3, 1, 0}, query);
        EXPECT_EQ(left.position, right.position);
        EXPECT_EQ(left.squaredDistance, right.squaredDistance);
    }
}

TriangleTree::Closest bruteForceClosest(const TriangleMesh& mesh, const Vec3& query) {
    TriangleTree::Closest best;
    best.squaredDistance = std::numeric_limits<double>::infinity();
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        const ClosestPointOnTriangle candidate =
            closestPointOnTriangle(mesh.vertices, mesh.faces[f], query);
        if (candidate.squaredDistance < best.squaredDistance) {
            best = {
                .point = {.face = static_cast<int>(f), .barycentric = candidate.barycentric},
                .position = candidate.position,
                .squaredDistance = candidate.squaredDistance,
            };
        }
    }
    return best;
}

void expectSameAsBruteForce(const TriangleMesh& mesh, const TriangleTree& tree, const Vec3& query) {
    const TriangleTree::Closest actual = tree.closestPoint(query);
    const TriangleTree::Closest expected = bruteForceClosest(mesh, query);
    EXPECT_EQ(actual.point.face, expected.point.face);
    EXPECT_EQ(actual.point.barycentric, expected.point.barycentric);
    EXPECT_EQ(actual.position, expected.position);
    EXPECT_EQ(actual.squaredDistance, expected.squaredDistance);
    expectBarycentric(actual.point.barycentric);
    const double distance = std::sqrt(expected.squaredDistance);
    const TriangleTree::Closest within = tree.closestPoint(query, 1.001 * distance + 1e-9);
    EXPECT_EQ(within.point.face, expected.point.face);
    EXPECT_EQ(within.position, expected.position);
    EXPECT_EQ(tree.closestPoint(query, 0.999 * distance).point.face, -1);
}

TEST(TriangleTree, FindsTheSameClosestPointAsBruteForceBitForBit) {
    SCOPED_TRACE("seed 4");
    Random random(4);
    for (const TriangleMesh& mesh :
         {renumbered(torus(24, 11), 1),
          jitteredPlate(15, 15, 0.25, 2),
          withNoise(icosphere(2), 0.3, 3),
          twoComponents()}) {
        const TriangleTree tree(mesh.vertices, mesh.faces);
        for (int i = 0; i < 200; ++i) {
            expectSameAsBruteForce(mesh, tree, random.point(-2.0, 2.0));
        }
    }
}

TEST(TriangleTree, ChoosesTheLowestOfSeveralEquallyCloseTriangles) {
    const TriangleMesh mesh = renumbered(torus(24, 11), 5);
    const TriangleTree tree(mesh.vertices, mesh.faces);
    for (const Vec3& vertex : mesh.vertices) {
        expectSameAsBruteForce(mesh, tree, vertex);
    }
    // The centre of a sphere is about equally far from everything.
    const TriangleMesh sphere = icosphere(2);
    expectSameAsBruteForce(sphere, TriangleTree(sphere.vertices, sphere.faces), Vec3::Zero());
    // Copies of one face.
    const std::vector<Triangle> copies(50, sphere.faces[3]);
    const TriangleTree copyTree(sphere.vertices, copies);
    EXPECT_EQ(copyTree.closestPoint(Vec3(0.3, 0.2, 2.0)).point.face, 0);
}

TEST(TriangleTree, FindsTheClosestPointWhereSquaresOfDistancesOverflow) {
    const TriangleMesh mesh = icosphere(1);
    const TriangleTree tree(mesh.vertices, mesh.faces);
    for (const double far : {1e150, 1e160, -1e300, std::numeric_limits<double>::max()}) {
        const TriangleTree::Closest closest = tree.closestPoint(Vec3(0.0, far, 0.5 * far));
        ASSERT_GE(closest.point.face, 0) << far;
        EXPECT_TRUE(std::isfinite(closest.squaredDistance)) << far;
    }
}

TEST(TriangleTree, FindsPointsOfTheSurfaceAtDistanceZero) {
    SCOPED_TRACE("seed 6");
    Random random(6);
    const TriangleMesh mesh = icosphere(3, 100.0);
    const TriangleTree tree(mesh.vertices, mesh.faces);
    for (int i = 0; i < 500; ++i) {
        const int face = random.integer(0, static_cast<int>(mesh.faces.size()) - 1);
        const auto& [a, b, c] = mesh.faces[face];
        const double u = random.uniform(0.0, 0.5);
        const double v = random.uniform(0.0, 0.5);
        const Vec3 query =
            (1.0 - u - v) * mesh.vertices[a] + u * mesh.vertices[b] + v * mesh.vertices[c];
        EXPECT_LT(std::sqrt(tree.closestPoint(query).squaredDistance), 1e-12);
    }
}

TEST(TriangleTree, AnswersForNoTriangles) {
    const std::vector<Vec3> vertices;
    const std::vector<Triangle> triangles;
    const TriangleTree tree(vertices, triangles);
    EXPECT_EQ(tree.closestPoint(Vec3::Zero()).point.face, -1);
    tree.forEachOverlappingPair([](int, int) { ADD_FAILURE(); });
}

using PairSet = std::set<std::pair<int, int>>;

PairSet overlapsByBruteForce(const TriangleMesh& mesh) {
    std::vector<Eigen::AlignedBox3d> boxes(mesh.faces.size());
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        for (const int vertex : mesh.faces[f]) {
            boxes[f].extend(mesh.vertices[vertex]);
        }
    }
    PairSet pairs;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        for (std::size_t j = i + 1; j < boxes.size(); ++j) {
            if (boxes[i].intersects(boxes[j])) {
                pairs.emplace(i, j);
            }
        }
    }
    return pairs;
}

TEST(TriangleTree, VisitsEveryPairOfOverlappingBoxesOnce) {
    const TriangleMesh single{.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .faces = {{0, 1, 2}}};
    for (const TriangleMesh& mesh :
         {single,
          plate(1, 1),
          plate(8, 8),
          box(3),
          icosphere(2),
          withNoise(torus(14, 8), 0.2, 7),
          crossingPlates()}) {
        const TriangleTree tree(mesh.vertices, mesh.faces);
        PairSet visited;
        tree.forEachOverlappingPair([&](int i, int j) {
            EXPECT_LT(i, j);
            EXPECT_TRUE(visited.emplace(i, j).second) << "visited twice: " << i << ", " << j;
        });
        EXPECT_EQ(visited, overlapsByBruteForce(mesh));
    }
}

}  // namespace
}  // namespace bspline_curve
