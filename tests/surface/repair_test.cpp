// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/repair.h"

#include "bspline_curve/error.h"
#include "support/meshes.h"
#include "support/random.h"
#include "support/refusal.h"
#include "surface/provenance.h"
#include "surface/surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>

namespace bspline_curve {

namespace {

using namespace test_support;
using VertexIds = std::vector<int>;

/// The validator's word on a mesh; "" where it takes it.
std::string refusalOf(const TriangleMesh& mesh) {
    const std::optional<InputError> error = refusal([&] { return Surface(mesh); });
    return error ? error->what() : "";
}

Vec3 pointOn(const TriangleMesh& mesh, const SurfacePoint& point) {
    Vec3 position = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
        position += point.barycentric[k] * mesh.vertices[mesh.faces[point.face][k]];
    }
    return position;
}

/// Repairs, and checks all that holds of every repair.
MeshRepair repaired(const TriangleMesh& mesh) {
    MeshRepair repair = repairMesh(mesh);
    EXPECT_EQ(refusalOf(repair.mesh), "");
    EXPECT_EQ(repair.vertexOrigins.size(), repair.mesh.vertices.size());
    EXPECT_EQ(repair.faceOrigins.size(), repair.mesh.faces.size());
    EXPECT_GE(repair.mesh.vertices.size(), mesh.vertices.size());
    for (std::size_t v = 0; v < repair.mesh.vertices.size(); ++v) {
        EXPECT_EQ(repair.mesh.vertices[v], mesh.vertices[repair.vertexOrigins[v]]);
        EXPECT_TRUE(v >= mesh.vertices.size() || repair.vertexOrigins[v] == static_cast<int>(v));
    }
    const Vec3 inside(0.2, 0.3, 0.5);
    const Provenance there(mesh, repair, {});
    for (int f = 0; f < static_cast<int>(repair.mesh.faces.size()); ++f) {
        const SurfacePoint point{f, inside};
        const SurfacePoint origin = repair.toOrigin(point);
        EXPECT_NEAR(origin.barycentric.sum(), 1.0, 1e-12);
        EXPECT_GE(origin.barycentric.minCoeff(), -1e-12);
        EXPECT_LT((pointOn(mesh, origin) - pointOn(repair.mesh, point)).norm(), 1e-9);
        const std::optional<SurfacePoint> back = there.fromInput(origin);
        EXPECT_TRUE(back && back->face == f);
        EXPECT_LT((back.value_or(SurfacePoint()).barycentric - inside).norm(), 1e-9);
        for (const Vec3& weights : {Vec3(0, 0.4, 0.6), Vec3(0.4, 0, 0.6), Vec3(0.4, 0.6, 0)}) {
            const SurfacePoint onEdge{f, weights};
            const SurfacePoint same =
                there.fromInput(repair.toOrigin(onEdge)).value_or(SurfacePoint{.face = 0});
            EXPECT_GE(same.barycentric.minCoeff(), 0.0);
            EXPECT_LT((pointOn(repair.mesh, same) - pointOn(repair.mesh, onEdge)).norm(), 1e-9);
        }
    }
    const MeshRepair again = repairMesh(repair.mesh, 0.0, true);
    EXPECT_TRUE(again.report.isEmpty()) << again.report.summary();
    EXPECT_EQ(again.mesh.faces, repair.mesh.faces);
    return repair;
}

/// The plate with a flap standing on the edge between the vertices of one of its cells' diagonals.
TriangleMesh plateWithFlap() {
    TriangleMesh mesh = plate(4, 4);
    const Triangle face = mesh.faces[10];
    mesh.vertices.emplace_back(0.5, 0.5, 0.4);
    mesh.faces.push_back({face[0], face[1], static_cast<int>(mesh.vertices.size()) - 1});
    return mesh;
}

}  // namespace

TEST(Repair, LeavesASoundMeshAlone) {
    for (const TriangleMesh& mesh : {plate(4, 3), torus(8, 6), joined(plate(2, 2), icosphere(1))}) {
        const MeshRepair repair = repaired(mesh);
        EXPECT_TRUE(repair.report.isEmpty());
        EXPECT_EQ(repair.report.summary(), "");
        EXPECT_EQ(repair.mesh.faces, mesh.faces);
    }
}

TEST(Repair, GivesTheLobesOfABowTieAVertexEach) {
    ASSERT_NE(refusalOf(bowTie()), "");
    const MeshRepair repair = repaired(bowTie());
    ASSERT_EQ(repair.report.duplicatedVertices.size(), 1U);
    EXPECT_EQ(repair.report.duplicatedVertices[0].vertex, 0);
    EXPECT_EQ(repair.report.duplicatedVertices[0].copies, VertexIds{5});
    EXPECT_EQ(repair.report.summary(), "1 vertex duplicated");
    EXPECT_EQ(repair.mesh.faces[0], bowTie().faces[0]);
    EXPECT_EQ(
        Provenance(bowTie(), repair, {}).valuesFromInput(std::vector<double>{7, 1, 2, 3, 4}),
        (std::vector<double>{7, 1, 2, 3, 4, 7})
    );
}

TEST(Repair, ThePartWithMoreFacesKeepsTheVertex) {
    TriangleMesh mesh = joined({.vertices = {{-1, 0, 0}, {-1, -1, 0}}, .faces = {}}, plate(2, 2));
    mesh.faces.insert(mesh.faces.begin(), {2, 0, 1});  // at the corner of the plate
    mesh.faces.insert(mesh.faces.begin(), {6, 1, 0});  // at its middle
    const MeshRepair repair = repaired(mesh);
    ASSERT_FALSE(repair.report.duplicatedVertices.empty());
    for (std::size_t f = 2; f < mesh.faces.size(); ++f) {
        for (std::size_t k = 0; k < 3; ++k) {
            const bool isTie = mesh.faces[f][k] == 2;  // one or two faces there, too
            EXPECT_TRUE(isTie || repair.mesh.faces[f][k] == mesh.faces[f][k]);
        }
    }
}

TEST(Repair, PartsThreeFacesAtAnEdge) {
    ASSERT_NE(refusalOf(threeFacesAtAnEdge()), "");
    const MeshRepair repair = repaired(threeFacesAtAnEdge());
    ASSERT_EQ(repair.report.cutEdges.size(), 1U);
    EXPECT_EQ(repair.report.cutEdges[0], (std::array{0, 1}));
    EXPECT_EQ(repair.mesh.faces.size(), 3U);
}

TEST(Repair, CutsAFlapOffThePlateAndKeepsThePlateWhole) {
    const TriangleMesh mesh = plateWithFlap();
    const MeshRepair repair = repaired(mesh);
    EXPECT_EQ(repair.report.cutEdges.size(), 1U);
    EXPECT_EQ(repair.report.duplicatedVertices.size(), 2U);
    EXPECT_TRUE(std::equal(mesh.faces.begin(), mesh.faces.end() - 1, repair.mesh.faces.begin()));
    EXPECT_EQ(Surface(repair.mesh).componentCount(), 2);
}

TEST(Repair, RemovesDuplicateFacesWhicheverWayTheyTurn) {
    TriangleMesh mesh = plate(3, 3);
    const Triangle a = mesh.faces[4];
    const Triangle b = mesh.faces[9];
    mesh.faces.push_back({a[1], a[2], a[0]});
    mesh.faces.insert(mesh.faces.begin() + 12, {b[0], b[2], b[1]});
    const MeshRepair repair = repaired(mesh);
    EXPECT_EQ(repair.report.removedDuplicateFaces, (VertexIds{12, 19}));
    EXPECT_EQ(repair.report.count(), 2);
    EXPECT_EQ(repair.mesh.faces, plate(3, 3).faces);
    EXPECT_EQ(repair.faceOrigins[11], 11);
    EXPECT_EQ(repair.faceOrigins[12], 13);
}

TEST(Repair, TurnsTheSmallerPartOfEachPatch) {
    TriangleMesh mesh = joined(icosphere(1), plate(3, 3));
    for (int f : {3, 17, 82, 83, 90}) {
        mesh = withFaceReversed(std::move(mesh), f);
    }
    const MeshRepair repair = repaired(mesh);
    EXPECT_EQ(repair.report.reversedFaces, (VertexIds{3, 17, 82, 83, 90}));
    EXPECT_EQ(repair.report.count(), 5);
}

TEST(Repair, AMeshThatIsWhollyTurnedStaysSo) {
    TriangleMesh mesh = icosphere(1);
    for (int f = 0; f < 80; ++f) {
        mesh = withFaceReversed(std::move(mesh), f);
    }
    EXPECT_TRUE(repaired(mesh).report.isEmpty());
}

TEST(Repair, MergesTheEndsOfAnEdgeWithoutLength) {
    TriangleMesh mesh = plate(4, 4);
    // A vertex of the middle of the plate moves onto its neighbour: two faces lose their area.
    mesh.vertices[2 * 5 + 2] = mesh.vertices[2 * 5 + 3];
    const MeshRepair repair = repaired(mesh);
    EXPECT_EQ(repair.report.removedDegenerateFaces.size(), 2U);
    EXPECT_EQ(repair.report.mergedVertices, (std::vector{std::pair(13, 12)}));
    const Surface surface(repair.mesh);
    EXPECT_EQ(surface.componentCount(), 1);
    int boundaryEdges = 0;
    for (const Triangle& neighbours : surface.faceNeighbours()) {
        boundaryEdges += static_cast<int>(std::ranges::count(neighbours, -1));
    }
    EXPECT_EQ(boundaryEdges, 16);
}

TEST(Repair, RemovesFacesThatRepeatAVertex) {
    TriangleMesh mesh = plate(2, 2);
    mesh.faces.insert(mesh.faces.begin() + 3, {4, 5, 5});
    mesh.faces.insert(mesh.faces.begin(), {1, 1, 1});
    const MeshRepair repair = repaired(mesh);
    EXPECT_EQ(repair.report.removedDegenerateFaces, (VertexIds{0, 4}));
    EXPECT_TRUE(repair.report.mergedVertices.empty());
    EXPECT_EQ(repair.mesh.faces, plate(2, 2).faces);
}

TEST(Repair, SplitsTheFaceBesideAFlatOneSoThatNoGapStays) {
    // Two squares, one of which has a vertex on the edge between them and a flat face there.
    const TriangleMesh mesh = {
        .vertices = {{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 2, 0}, {1, -2, 0}},
        .faces = {{0, 2, 3}, {2, 1, 3}, {0, 1, 2}, {1, 0, 4}}
    };
    ASSERT_NE(refusalOf(mesh), "");
    const MeshRepair repair = repaired(mesh);
    EXPECT_EQ(repair.report.removedDegenerateFaces, VertexIds{2});
    EXPECT_EQ(repair.report.splitFaces, VertexIds{3});
    EXPECT_EQ(repair.faceOrigins, (VertexIds{0, 1, 3, 3}));
    const Surface surface(repair.mesh);
    EXPECT_FALSE(surface.isBoundaryVertex(2));
}

TEST(Repair, SplitsSeveralFlatFacesOneAfterTheOther) {
    // A fan of flat faces along one long edge.
    const int count = 6;
    TriangleMesh mesh;
    for (int i = 0; i <= count; ++i) {
        mesh.vertices.emplace_back(i, 0, 0);
    }
    mesh.vertices.emplace_back(3, 5, 0);
    mesh.vertices.emplace_back(3, -5, 0);
    for (int i = 0; i < count; ++i) {
        mesh.faces.push_back({i, i + 1, count + 1});
        if (i > 0) {
            mesh.faces.push_back({0, i + 1, i});
        }
    }
    mesh.faces.push_back({count, 0, count + 2});
    const MeshRepair repair = repaired(mesh);
    EXPECT_EQ(repair.report.removedDegenerateFaces.size(), 5U);
    EXPECT_EQ(repair.mesh.faces.size(), mesh.faces.size());
    const Surface surface(repair.mesh);
    for (int i = 1; i < count; ++i) {
        EXPECT_FALSE(surface.isBoundaryVertex(i));
    }
}

TEST(Repair, TakesALongRowOfFlatFacesAwayInTimeThatGrowsWithItsLength) {
    // Round vertex 0, each on the long side of the one before: one can go after the other.
    const int count = 100000;
    TriangleMesh mesh = {.vertices = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}, .faces = {{0, 2, 1}}};
    for (int i = 2; i < count + 2; ++i) {
        mesh.vertices.emplace_back(i, 0, 0);
        mesh.faces.push_back({0, i, i + 1});
    }
    const MeshRepair repair = repaired(mesh);  // hours, were it quadratic
    EXPECT_EQ(repair.report.removedDegenerateFaces.size(), count);
    EXPECT_EQ(repair.mesh.faces, std::vector<Triangle>{mesh.faces.front()});
}

TEST(Repair, PartsTwoFacesOfWhichEachEdgeIsHeldTogetherAtItsEnds) {
    // Two spheres of which one edge each is made the same: both fans at both ends meet all around.
    const Eigen::Isometry3d aside(Eigen::Translation3d(3.0, 0.0, 0.0));
    TriangleMesh mesh = joined(icosphere(1), transformed(icosphere(1), aside));
    const int shift = static_cast<int>(icosphere(1).vertices.size());
    const int u = mesh.faces[0][0];
    const int v = mesh.faces[0][1];
    for (Triangle& face : mesh.faces) {
        std::ranges::replace(face, u + shift, u);
        std::ranges::replace(face, v + shift, v);
    }
    const MeshRepair repair = repaired(mesh);
    EXPECT_EQ(repair.report.cutEdges.size(), 1U);
    EXPECT_EQ(Surface(repair.mesh).componentCount(), 2);
    EXPECT_EQ(repair.report.duplicatedVertices.size(), 2U);
}

TEST(Repair, CutsOneSidedSurfacesOpen) {
    const MeshRepair strip = repaired(moebiusStrip(12));
    EXPECT_EQ(strip.report.cutEdges.size(), 1U);
    EXPECT_EQ(strip.report.duplicatedVertices.size(), 2U);
    EXPECT_EQ(Surface(strip.mesh).componentCount(), 1);
    // The projective plane: a half of an icosphere is left of each pair of opposite faces.
    const TriangleMesh sphere = icosphere(2);
    std::vector<int> opposite(sphere.vertices.size());
    for (std::size_t v = 0; v < opposite.size(); ++v) {
        const auto distance = [&](const Vec3& p) { return (p + sphere.vertices[v]).norm(); };
        const auto other = std::ranges::min_element(sphere.vertices, {}, distance);
        opposite[v] = static_cast<int>(other - sphere.vertices.begin());
    }
    TriangleMesh plane{.vertices = sphere.vertices, .faces = {}};
    for (Triangle face : sphere.faces) {
        const Vec3 middle =
            (sphere.vertices[face[0]] + sphere.vertices[face[1]] + sphere.vertices[face[2]]) / 3.0;
        if (middle.dot(Vec3(1.0, 0.1, 0.01)) > 0.0) {
            for (int& v : face) {
                v = std::min(v, opposite[v]);
            }
            plane.faces.push_back(face);
        }
    }
    const MeshRepair cut = repaired(plane);
    EXPECT_FALSE(cut.report.cutEdges.empty());
    EXPECT_EQ(Surface(cut.mesh).componentCount(), 1);
    EXPECT_EQ(cut.mesh.faces.size(), sphere.faces.size() / 2);
}

TEST(Repair, RefusesWhatItCannotRepair) {
    TriangleMesh mesh = plate(2, 2);
    mesh.faces[1][2] = 99;
    EXPECT_THROW(static_cast<void>(repairMesh(mesh)), InputError);
}

TEST(Repair, MakesOfAnyTrianglesASurface) {
    int repairedCount = 0;
    for (std::uint64_t seed = 0; seed < 3000; ++seed) {
        Random random(seed);
        TriangleMesh mesh;
        const int vertexCount = 4 + static_cast<int>(9.0 * random.uniform(0.0, 1.0));
        for (int v = 0; v < vertexCount; ++v) {
            // Some on a coarse grid, so that points and lines coincide.
            const bool isOnGrid = random.uniform(0.0, 1.0) < 0.5;
            const auto coordinate = [&] {
                const double x = random.uniform(0.0, 3.0);
                return isOnGrid ? std::floor(x) : x;
            };
            const double x = coordinate();
            const double y = coordinate();
            mesh.vertices.emplace_back(x, y, isOnGrid ? 0.0 : coordinate());
        }
        const int faceCount = 1 + static_cast<int>(24.0 * random.uniform(0.0, 1.0));
        for (int f = 0; f < faceCount; ++f) {
            const auto vertex = [&] {
                return static_cast<int>(random.uniform(0.0, 1.0) * (vertexCount - 1e-9));
            };
            const int a = vertex();
            const int b = vertex();
            mesh.faces.push_back({a, b, vertex()});
        }
        SCOPED_TRACE("seed " + std::to_string(seed));
        if (!repairMesh(mesh).mesh.faces.empty()) {
            const MeshRepair repair = repaired(mesh);
            EXPECT_EQ(repairMesh(mesh).mesh.faces, repair.mesh.faces);
            ++repairedCount;
        }
        if (testing::Test::HasFailure()) {
            return;
        }
    }
    EXPECT_GT(repairedCount, 2000);
}

}  // namespace bspline_curve
