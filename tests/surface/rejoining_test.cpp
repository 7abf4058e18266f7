// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/rejoining.h"

#include "support/meshes.h"
#include "support/random.h"
#include "surface/surface.h"
#include "surface/ways_over_faces.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

/// A mended mesh, joined anew for a way over some of its faces.
struct RejoinedWay {
    Surface mended;
    bool isFound;
    Passages passages;
    Surface surface;
    MeshRepair repair;
};

RejoinedWay rejoinedFor(const TriangleMesh& mesh, const std::vector<int>& faces) {
    Surface mended(mesh, MendingOptions());
    const std::vector<int> roots = mended.provenance().vertexRoots();
    const PartedEdges parted(mended, roots);
    WaysOverFaces ways(mended, parted, {});
    std::vector<Step> steps;
    bool isFound = true;
    for (std::size_t i = 0; i + 1 < faces.size(); ++i) {
        const Vec3 middle = Vec3::Constant(1.0 / 3.0);
        const std::optional<FaceWay> way =
            ways.find({faces[i], middle}, {faces[i + 1], middle}, Crossing::Parted);
        isFound = isFound && way;
        if (way) {
            steps.insert(steps.end(), way->steps.begin(), way->steps.end());
        }
    }
    Passages passages = passagesOf(steps);
    MeshRepair repair = rejoined(mended.mesh(), roots, parted, passages);
    Surface surface(repair.mesh);
    return {std::move(mended), isFound, std::move(passages), std::move(surface), std::move(repair)};
}

/// The component of the rejoined surface that a mended face lies in; its parts must agree.
int componentOf(const RejoinedWay& way, int face) {
    int component = -1;
    for (int f = 0; f < way.surface.faceCount(); ++f) {
        if (way.repair.faceOrigins[f] == face) {
            EXPECT_TRUE(component < 0 || component == way.surface.faceComponents()[f]);
            component = way.surface.faceComponents()[f];
        }
    }
    return component;
}

/// Expects the points of the rejoined surface where the mended one has them, all of it.
void expectSamePoints(const RejoinedWay& way) {
    EXPECT_NEAR(way.surface.area(), way.mended.area(), 1e-12 * way.surface.area());
    for (int f = 0; f < way.surface.faceCount(); ++f) {
        for (const Vec3& weights : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0.2, 0.3, 0.5)}) {
            const Vec3 here = way.surface.position({f, weights});
            const Vec3 there = way.mended.position(way.repair.toOrigin({f, weights}));
            EXPECT_LT((here - there).norm(), 1e-12 * way.surface.diagonal());
        }
    }
}

TEST(Rejoining, LetsEachOfThreeFacesGoOnIntoEachOther) {
    for (const std::vector<int>& faces :
         {std::vector{0, 1}, {0, 2}, {1, 2}, {0, 1, 2}, {2, 0, 1}, {0, 1, 2, 0}}) {
        const RejoinedWay way = rejoinedFor(threeFacesAtAnEdge(), faces);
        expectSamePoints(way);
        for (const int face : faces) {
            EXPECT_EQ(componentOf(way, face), componentOf(way, faces.front()));
        }
    }
}

TEST(Rejoining, JoinsAFinToAPlateForItsWayAlone) {
    TriangleMesh mesh = plate(4, 4);
    const Triangle face = mesh.faces[10];
    mesh.vertices.emplace_back(0.5, 0.5, 0.4);
    mesh.faces.push_back({face[0], face[1], static_cast<int>(mesh.vertices.size()) - 1});
    EXPECT_EQ(rejoinedFor(mesh, {3, 30, 7}).surface.componentCount(), 2);
    const RejoinedWay way = rejoinedFor(mesh, {3, 32});
    EXPECT_EQ(way.passages.stretches.size(), 1U);
    EXPECT_EQ(way.surface.componentCount(), 1);
    expectSamePoints(way);
    EXPECT_EQ(rejoinedFor(mesh, {3, 32, 30}).surface.componentCount(), 1);
}

TEST(Rejoining, FindsNoWayBetweenWhatIsApart) {
    const TriangleMesh mesh = joined(threeFacesAtAnEdge(), plate(2, 2));
    EXPECT_FALSE(rejoinedFor(mesh, {0, 5}).isFound);
    EXPECT_FALSE(rejoinedFor(mesh, {0, 2, 5}).isFound);
}

TEST(Rejoining, LeavesNoFaceCutOutOfItsNeighbours) {
    // Two spheres of which one edge each is made the same: mending cuts one of the faces out.
    const Eigen::Isometry3d aside(Eigen::Translation3d(3.0, 0.0, 0.0));
    TriangleMesh mesh = joined(icosphere(1), transformed(icosphere(1), aside));
    const int shift = static_cast<int>(icosphere(1).vertices.size());
    for (Triangle& face : mesh.faces) {
        std::ranges::replace(face, mesh.faces[0][0] + shift, mesh.faces[0][0]);
        std::ranges::replace(face, mesh.faces[0][1] + shift, mesh.faces[0][1]);
    }
    const int last = static_cast<int>(mesh.faces.size()) - 1;
    const RejoinedWay way = rejoinedFor(mesh, {5, last});
    EXPECT_EQ(way.passages.stretches.size(), 1U);
    EXPECT_EQ(componentOf(way, 5), componentOf(way, last));
    expectSamePoints(way);
}

// Whatever is connected by edges in the given mesh is a way, unless sides disagree on it.
TEST(Rejoining, JoinsFacesAmongFewVertices) {
    int ways = 0;
    int found = 0;
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        TriangleMesh mesh;
        for (int v = 0; v < 7; ++v) {
            mesh.vertices.push_back(random.point(-1.0, 1.0));
        }
        for (int f = 0; f < 16; ++f) {
            const int a = random.integer(0, 6);
            const int b = (a + random.integer(1, 6)) % 7;
            int c = a;
            while (c == a || c == b) {
                c = random.integer(0, 6);
            }
            mesh.faces.push_back({a, b, c});
        }
        const int last = static_cast<int>(repairMesh(mesh).mesh.faces.size()) - 1;
        const std::vector<int> faces = {0, last / 2, last};
        const RejoinedWay way = rejoinedFor(mesh, faces);
        expectSamePoints(way);
        if (!way.isFound) {
            continue;
        }
        ++ways;
        bool isOne = true;
        for (int f = 0; f < way.surface.faceCount(); ++f) {
            for (const int face : faces) {
                isOne = isOne && (way.repair.faceOrigins[f] != face ||
                                  way.surface.faceComponents()[f] ==
                                      way.surface.faceComponents()[faces.front()]);
            }
        }
        found += isOne ? 1 : 0;
    }
    EXPECT_GT(ways, 100);
    EXPECT_GE(found, ways * 9 / 10);
}

}  // namespace
}  // namespace bspline_curve
