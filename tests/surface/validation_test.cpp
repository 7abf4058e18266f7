// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/error.h"
#include "support/meshes.h"
#include "surface/surface.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace bspline_curve {
namespace {

using namespace test_support;
using Elements = std::vector<std::int64_t>;

InputError refusal(const TriangleMesh& mesh) {
    try {
        const Surface surface(mesh);
    } catch (const InputError& error) {
        return error;
    }
    ADD_FAILURE() << "the mesh was accepted";
    return {InputErrorCode::UnreadableFile, ""};
}

void expectMentions(const InputError& error, const std::string& text) {
    EXPECT_NE(std::string(error.what()).find(text), std::string::npos)
        << '"' << error.what() << "\" does not mention \"" << text << '"';
}

TEST(Validation, RefusesAMeshWithoutFaces) {
    EXPECT_EQ(refusal({}).code(), InputErrorCode::EmptyMesh);
    TriangleMesh cloud = plate(2, 2);
    cloud.faces.clear();
    EXPECT_EQ(refusal(cloud).code(), InputErrorCode::EmptyMesh);
}

TEST(Validation, RefusesCoordinatesThatAreNotFiniteAndNamesTheVertices) {
    TriangleMesh mesh = plate(3, 3);
    mesh.vertices[2][1] = std::numeric_limits<double>::quiet_NaN();
    mesh.vertices[5][0] = -std::numeric_limits<double>::infinity();
    mesh.vertices[7][2] = 1e61;
    const InputError error = refusal(mesh);
    EXPECT_EQ(error.code(), InputErrorCode::NonFiniteCoordinate);
    EXPECT_EQ(error.elements(), (Elements{2, 5, 7}));
    expectMentions(error, "3 vertices");
    expectMentions(error, "2, 5, 7");
}

TEST(Validation, RefusesNonFiniteCoordinatesOfUnreferencedVerticesToo) {
    TriangleMesh mesh = plate(1, 1);
    mesh.vertices.emplace_back(0, 0, std::numeric_limits<double>::infinity());
    EXPECT_EQ(refusal(mesh).elements(), (Elements{4}));
}

TEST(Validation, RefusesIndicesOutOfRangeAndNamesTheFaces) {
    TriangleMesh mesh = plate(2, 1);
    mesh.faces[1][2] = 6;
    mesh.faces[3][0] = -1;
    const InputError error = refusal(mesh);
    EXPECT_EQ(error.code(), InputErrorCode::IndexOutOfRange);
    EXPECT_EQ(error.elements(), (Elements{1, 3}));
    expectMentions(error, "0 to 5");
}

TEST(Validation, RefusesFacesWithARepeatedVertexOrPosition) {
    TriangleMesh mesh = plate(4, 1);
    mesh.faces[2][1] = mesh.faces[2][0];
    mesh.vertices.push_back(mesh.vertices[0]);
    mesh.faces.push_back({0, 1, static_cast<int>(mesh.vertices.size()) - 1});
    const InputError error = refusal(mesh);
    EXPECT_EQ(error.code(), InputErrorCode::DegenerateFace);
    EXPECT_EQ(error.elements(), (Elements{2, 8}));
    expectMentions(error, "'Remove Zero Area Faces'");
}

TEST(Validation, RefusesCollinearCornersEvenWhereRoundingLiftsThemOffTheLine) {
    // y = 3 x in decimal fractions is not exactly collinear in binary.
    for (const double offset : {0.0, 1e3, 1e6}) {
        const auto point = [&](double x) { return Vec3(offset + x, offset + 3.0 * x, 0.7 * x); };
        const TriangleMesh mesh{
            .vertices = {point(0.1), point(0.2), point(0.7)}, .faces = {{0, 1, 2}}
        };
        EXPECT_EQ(refusal(mesh).code(), InputErrorCode::DegenerateFace) << "offset " << offset;
    }
}

TEST(Validation, AcceptsNeedlesWhoseHeightIsMoreThanRounding) {
    const TriangleMesh needle{
        .vertices = {{0, 0, 0}, {1, 0, 0}, {0.5, 1e-13, 0}}, .faces = {{0, 1, 2}}
    };
    EXPECT_EQ(Surface(needle).faceNormal(0), Vec3::UnitZ());
}

TEST(Validation, AcceptsAnyUnitOfLength) {
    for (const double scale : {1e-30, 1e-9, 1.0, 1e9, 1e30}) {
        const TriangleMesh mesh = transformed(icosphere(1), Eigen::Isometry3d::Identity(), scale);
        EXPECT_EQ(Surface(mesh).componentCount(), 1) << "scale " << scale;
    }
}

TEST(Validation, RefusesAnEdgeWithThreeFacesAndNamesThem) {
    const InputError error = refusal(threeFacesAtAnEdge());
    EXPECT_EQ(error.code(), InputErrorCode::NonManifoldEdge);
    EXPECT_EQ(error.elements(), (Elements{0, 1, 2}));
    expectMentions(error, "1 edge joins");
    expectMentions(error, "'Repair non Manifold Edges'");
}

TEST(Validation, RefusesTwoCopiesOfAFaceWhicheverWayTheyAreTurned) {
    const TriangleMesh single{.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .faces = {{0, 1, 2}}};
    TriangleMesh same = single;
    same.faces.push_back({1, 2, 0});
    EXPECT_EQ(refusal(same).code(), InputErrorCode::NonManifoldEdge);
    TriangleMesh opposite = single;
    opposite.faces.push_back({1, 0, 2});
    const InputError error = refusal(opposite);
    EXPECT_EQ(error.code(), InputErrorCode::NonManifoldEdge);
    EXPECT_EQ(error.elements(), (Elements{0, 1}));
    expectMentions(error, "'Remove Duplicate Faces'");
}

TEST(Validation, RefusesNeighboursThatAreTurnedOppositeWays) {
    const TriangleMesh sphere = icosphere(0);
    const InputError error = refusal(withFaceReversed(sphere, 7));
    EXPECT_EQ(error.code(), InputErrorCode::InconsistentOrientation);
    EXPECT_EQ(error.elements().size(), 4U) << "the face and its three neighbours";
    expectMentions(error, "3 edges join");
    expectMentions(error, "'Re-Orient all faces coherently'");
}

TEST(Validation, RefusesAOneSidedSurface) {
    const InputError error = refusal(moebiusStrip(12));
    EXPECT_EQ(error.code(), InputErrorCode::InconsistentOrientation);
    expectMentions(error, "1 edge joins");
    expectMentions(error, "one-sided");
}

TEST(Validation, RefusesAVertexWithTwoFansAndNamesIt) {
    const InputError error = refusal(bowTie());
    EXPECT_EQ(error.code(), InputErrorCode::NonManifoldVertex);
    EXPECT_EQ(error.elements(), (Elements{0}));
    expectMentions(error, "'Repair non Manifold Vertices by splitting'");
}

TEST(Validation, RefusesTwoClosedSurfacesThatShareAVertex) {
    // The second sphere's vertex 0 becomes the first's vertex 3.
    TriangleMesh mesh = twoComponents();
    const int second = static_cast<int>(mesh.vertices.size()) / 2;
    for (Triangle& face : mesh.faces) {
        for (int& vertex : face) {
            vertex = vertex == second ? 3 : vertex;
        }
    }
    const InputError error = refusal(mesh);
    EXPECT_EQ(error.code(), InputErrorCode::NonManifoldVertex);
    EXPECT_EQ(error.elements(), (Elements{3}));
}

TEST(Validation, CountsTheThirdEdgeOfTwoCopiesBetweenCrowdedEdges) {
    // Around vertex 1 the copies lie in a closed chain of faces that passes the edge (0, 1) twice.
    const TriangleMesh mesh{
        .vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}},
        .faces = {{1, 0, 2}, {1, 2, 3}, {1, 3, 0}, {1, 0, 4}, {1, 4, 0}},
    };
    const InputError error = refusal(mesh);
    EXPECT_EQ(error.code(), InputErrorCode::NonManifoldEdge);
    EXPECT_EQ(error.elements(), (Elements{0, 2, 3, 4}));
    expectMentions(error, "3 edges join");
}

TEST(Validation, ReportsTheFirstOfSeveralDefectsInTheDocumentedOrder) {
    TriangleMesh mesh = joined(bowTie(), withFaceReversed(icosphere(0), 2));
    EXPECT_EQ(refusal(mesh).code(), InputErrorCode::InconsistentOrientation);
    mesh = joined(mesh, threeFacesAtAnEdge());
    EXPECT_EQ(refusal(mesh).code(), InputErrorCode::NonManifoldEdge);
    mesh.faces.push_back({0, 0, 1});
    EXPECT_EQ(refusal(mesh).code(), InputErrorCode::DegenerateFace);
    mesh.faces.push_back({0, 1, 1000});
    EXPECT_EQ(refusal(mesh).code(), InputErrorCode::IndexOutOfRange);
    mesh.vertices[0][0] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(refusal(mesh).code(), InputErrorCode::NonFiniteCoordinate);
}

TEST(Validation, NamesAllElementsInTheErrorButOnlySomeInTheMessage) {
    TriangleMesh mesh = plate(10, 1);
    for (Triangle& face : mesh.faces) {
        face[2] = face[0];
    }
    const InputError error = refusal(mesh);
    EXPECT_EQ(error.elements().size(), 20U);
    expectMentions(error, "20 faces");
    expectMentions(error, "0, 1, 2, 3, 4 and 15 more");
}

}  // namespace
}  // namespace bspline_curve
