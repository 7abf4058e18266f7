// SPDX-License-Identifier: GPL-3.0-or-later
// The meshes that all tests rely on are what they say.
#include "support/meshes.h"
#include "support/orientation.h"
#include "support/random.h"
#include "surface/surface.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bspline_curve {
namespace {

using namespace test_support;

/// Vertices - edges + faces; without unreferenced vertices.
int eulerCharacteristic(const TriangleMesh& mesh) {
    const Surface surface(mesh);
    int boundaryEdges = 0;
    for (const Triangle& neighbours : surface.faceNeighbours()) {
        boundaryEdges += static_cast<int>(std::ranges::count(neighbours, -1));
    }
    const int edges = (3 * surface.faceCount() + boundaryEdges) / 2;
    return surface.vertexCount() - edges + surface.faceCount();
}

double area(const TriangleMesh& mesh) {
    double twice = 0.0;
    for (const auto& [a, b, c] : mesh.faces) {
        const Vec3& origin = mesh.vertices[a];
        const Vec3 ab = mesh.vertices[b] - origin;
        const Vec3 ac = mesh.vertices[c] - origin;
        twice += ab.cross(ac).norm();
    }
    return 0.5 * twice;
}

TEST(TestMeshes, HaveTheTopologyThatTheirNamesSay) {
    EXPECT_EQ(eulerCharacteristic(plate(5, 3)), 1);
    EXPECT_EQ(eulerCharacteristic(openCylinder(7, 3)), 0);
    EXPECT_EQ(eulerCharacteristic(icosphere(2)), 2);
    EXPECT_EQ(eulerCharacteristic(torus(9, 6)), 0);
    EXPECT_EQ(eulerCharacteristic(box(3)), 2);
    EXPECT_EQ(eulerCharacteristic(twoComponents()), 4);
    EXPECT_EQ(eulerCharacteristic(crossingPlates()), 2);
}

TEST(TestMeshes, AreOrientedOutwards) {
    EXPECT_NEAR(volumeOf(icosphere(4, 2.0)), 32.0 / 3.0 * std::numbers::pi, 0.15);
    EXPECT_NEAR(volumeOf(torus(80, 40)), 2.0 * std::pow(std::numbers::pi * 0.3, 2), 0.02);
    EXPECT_NEAR(volumeOf(box(3, {1, 2, 3})), 6.0, 1e-12);
    EXPECT_EQ(Surface(plate(2, 2)).faceNormal(0), Vec3::UnitZ());
    EXPECT_NEAR(Surface(openCylinder(40, 2)).faceNormal(0)[0], 1.0, 0.01);
}

TEST(TestMeshes, HaveTheFaceCountsThatTheyDocument) {
    EXPECT_EQ(icosphere(3).faces.size(), 1280U);
    EXPECT_EQ(twoComponents().faces.size(), 160U);
    EXPECT_EQ(plate(5, 3).faces.size(), 30U);
    EXPECT_EQ(box(3).faces.size(), 108U);
}

TEST(TestMeshes, MidpointSubdivisionKeepsTheSurface) {
    const TriangleMesh mesh = jitteredPlate(5, 5, 0.25, 1);
    const TriangleMesh fine = midpointSubdivide(mesh);
    EXPECT_EQ(fine.faces.size(), 4 * mesh.faces.size());
    EXPECT_NEAR(area(fine), area(mesh), 1e-14);
    EXPECT_EQ(eulerCharacteristic(fine), eulerCharacteristic(mesh));
    EXPECT_NEAR(Surface(fine).averageEdgeLength(), 0.5 * Surface(mesh).averageEdgeLength(), 0.01);
}

TEST(TestMeshes, JitterStaysInThePlaneAndKeepsTheBoundary) {
    const TriangleMesh mesh = jitteredPlate(8, 8, 0.29, 2);
    EXPECT_NEAR(area(mesh), 1.0, 1e-14) << "a folded face would count twice";
    const Surface surface(mesh);
    for (int face = 0; face < surface.faceCount(); ++face) {
        EXPECT_GT(surface.faceNormal(face)[2], 0.0);
    }
}

TEST(TestMeshes, RenumberingKeepsAreaAndOrientation) {
    const TriangleMesh mesh = torus(20, 10);
    const TriangleMesh other = renumbered(mesh, 3);
    EXPECT_NE(other.faces, mesh.faces);
    EXPECT_NEAR(area(other), area(mesh), 1e-12);
    EXPECT_NEAR(volumeOf(other), volumeOf(mesh), 1e-12);
}

TEST(TestMeshes, RandomMotionsAreRigid) {
    Random random(4);
    for (int i = 0; i < 20; ++i) {
        const Eigen::Matrix3d rotation = random.isometry(1.0).linear();
        EXPECT_LT((rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-14);
        EXPECT_GT(rotation.determinant(), 0.0);
    }
}

}  // namespace
}  // namespace bspline_curve
