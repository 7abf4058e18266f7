// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/seams.h"

#include "bspline_curve/mesh.h"
#include "support/meshes.h"
#include "surface/surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

Surface mendedSurface(const TriangleMesh& mesh, const MendingOptions& options = {}) {
    return Surface(mesh, options);
}

int boundaryEdges(const Surface& surface) {
    int count = 0;
    for (const Triangle& neighbours : surface.faceNeighbours()) {
        count += static_cast<int>(std::ranges::count(neighbours, -1));
    }
    return count;
}

/// Longitudes and latitudes, as texture coordinates have them: a vertex at a pole for each of its
/// faces, and two columns at one place.
TriangleMesh texturedSphere(int columns, int rows) {
    TriangleMesh mesh = plate(columns, rows);
    for (Vec3& at : mesh.vertices) {
        const int column = static_cast<int>(std::lround(at.x() * columns)) % columns;
        const double longitude = 2.0 * M_PI * column / columns;
        const double radius = at.y() == 0.0 || at.y() == 1.0 ? 0.0 : std::sin(M_PI * at.y());
        at = {radius * std::cos(longitude), radius * std::sin(longitude), -std::cos(M_PI * at.y())};
    }
    return mesh;
}

TEST(Seams, OfACylinderAreJoinedUnlessTheyAreToStay) {
    const TriangleMesh mesh = slitAlongZ(openCylinder(12, 5));
    ASSERT_EQ(findSeams(mesh).size(), 5U);
    const Surface mended = mendedSurface(mesh);
    ASSERT_FALSE(mended.provenance().isIdentity());
    EXPECT_EQ(boundaryEdges(mended), 24);
    EXPECT_EQ(mended.faces(), openCylinder(12, 5).faces);
    const RepairReport& report = (*mended.provenance().report());
    EXPECT_EQ(report.joinedEdges.size(), 5U);
    EXPECT_EQ(report.joinedVertices.size(), 6U);
    for (const auto& [vertex, into] : report.joinedVertices) {
        EXPECT_EQ(mesh.vertices[vertex], mesh.vertices[into]);
        EXPECT_LT(into, vertex);
    }
    EXPECT_EQ(
        mended.provenance().note(),
        "the mesh was mended: 5 pairs of edges on each other joined; the option slits leaves these "
        "open"
    );
    const std::vector<double> values(mended.vertexCount(), 2.0);
    EXPECT_EQ(mended.provenance().valuesOfInput(values), std::vector(mesh.vertices.size(), 2.0));
    for (const MendingOptions& options : {MendingOptions{.strict = true}, {.slits = true}}) {
        const Surface open = mendedSurface(mesh, options);
        EXPECT_TRUE(open.provenance().isIdentity());
        EXPECT_EQ(boundaryEdges(open), 34);
    }
}

TEST(Seams, OfATexturedSphereCloseItWithItsPoles) {
    const TriangleMesh mesh = texturedSphere(8, 6);
    const Surface mended = mendedSurface(mesh);
    ASSERT_FALSE(mended.provenance().isIdentity());
    EXPECT_EQ(boundaryEdges(mended), 0);
    EXPECT_EQ(mended.componentCount(), 1);
}

TEST(Seams, AreFoundWhicheverWayTheirFacesLook) {
    TriangleMesh mesh = slitAlongZ(openCylinder(12, 5));
    for (Triangle& face : mesh.faces) {
        if (mesh.vertices[face[0]].y() + mesh.vertices[face[1]].y() < 0.0) {
            std::swap(face[0], face[1]);
        }
    }
    EXPECT_EQ(findSeams(mesh).size(), 5U);
    EXPECT_EQ(boundaryEdges(mendedSurface(mesh)), 24);
}

TEST(Seams, AreNoneBetweenSheetsThatLieOnEachOther) {
    const TriangleMesh sphere = icosphere(1);
    const TriangleMesh cylinder = openCylinder(12, 5);
    TriangleMesh turned = plate(4, 4);
    for (Triangle& face : turned.faces) {
        std::swap(face[0], face[1]);
    }
    for (const TriangleMesh& mesh :
         {joined(sphere, sphere), joined(cylinder, cylinder), joined(plate(4, 4), turned)}) {
        EXPECT_TRUE(findSeams(mesh).empty());
        EXPECT_TRUE(mendedSurface(mesh).provenance().isIdentity());
    }
    // At a seam of two layers it is open which sides belong together.
    const TriangleMesh slit = slitAlongZ(cylinder);
    EXPECT_TRUE(findSeams(joined(slit, slit)).empty());
}

TEST(Seams, StayOpenWhereTheSurfaceWouldBecomeOneSided) {
    const Surface cut(repairMesh(moebiusStrip(12)).mesh);
    EXPECT_EQ(findSeams(cut.mesh()).size(), 1U);
    const Surface mended = mendedSurface(cut.mesh());
    EXPECT_EQ(mended.faces(), cut.faces());
    EXPECT_TRUE(mended.provenance().isIdentity());
}

// A vertex that two sheets share beside a seam, and edges of three faces at its end.
TEST(Seams, LeaveASurfaceWhateverIsAround) {
    TriangleMesh mesh = slitAlongZ(openCylinder(12, 5));
    const Seam seam = findSeams(mesh).front();
    const auto tip = static_cast<int>(mesh.vertices.size());
    mesh.vertices.emplace_back(3.0, 0.0, 0.3);
    mesh.vertices.emplace_back(3.0, 0.5, 0.3);
    mesh.faces.push_back({seam.a.low, seam.a.high, tip});
    mesh.faces.push_back({seam.b.high, tip + 1, tip});
    const Surface mended = mendedSurface(mesh);
    ASSERT_FALSE(mended.provenance().isIdentity());
    EXPECT_GE((*mended.provenance().report()).joinedEdges.size(), 4U);
    EXPECT_EQ(mended.faceCount(), static_cast<int>(mesh.faces.size()));
    for (int f = 0; f < mended.faceCount(); ++f) {
        for (int k = 0; k < 3; ++k) {
            const SurfacePoint at{.face = f, .barycentric = Vec3::Unit(k)};
            const auto [face, weights] = mended.provenance().toInput(at);
            Vec3 there = Vec3::Zero();
            for (int i = 0; i < 3; ++i) {
                there += weights[i] * mesh.vertices[mesh.faces[face][i]];
            }
            EXPECT_EQ(mended.position(at), there);
        }
    }
}

// Two faces without area lie in a slit and close it.
TEST(Seams, ThatFacesWithoutAreaHadClosedAreNone) {
    TriangleMesh mesh = slitAlongZ(openCylinder(12, 2));
    ASSERT_EQ(findSeams(mesh).size(), 2U);
    EXPECT_TRUE(mendedSurface(mesh).provenance().hasInputCorners());
    const auto at = [&](const Vec3& place, int which) {
        for (int v = 0;; ++v) {
            if ((mesh.vertices.at(v) - place).norm() < 1e-9 && which-- == 0) {
                return v;
            }
        }
    };
    // Both ends become one vertex each, the middle stays doubled.
    for (const double z : {0.0, 2.0}) {
        const int one = at({1, 0, z}, 0);
        const int other = at({1, 0, z}, 1);
        for (Triangle& face : mesh.faces) {
            std::ranges::replace(face, other, one);
        }
    }
    const int low = at({1, 0, 0}, 0);
    const int high = at({1, 0, 2}, 0);
    const int middle = at({1, 0, 1}, 0);
    const int copy = at({1, 0, 1}, 1);
    mesh.faces.push_back({low, high, middle});
    mesh.faces.push_back({high, low, copy});
    const Surface mended = mendedSurface(mesh);
    EXPECT_EQ(mended.provenance().report()->joinedEdges.size(), 2U);
    EXPECT_EQ(boundaryEdges(mended), 24);
    EXPECT_FALSE(mended.provenance().hasInputCorners());
}

}  // namespace
}  // namespace bspline_curve
