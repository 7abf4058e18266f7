// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/provenance.h"

#include "bspline_curve/error.h"
#include "support/meshes.h"
#include "support/refusal.h"
#include "surface/strict_line.h"
#include "surface/surface.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

TEST(Provenance, IsTheIdentityOfASoundMesh) {
    const TriangleMesh mesh = plate(3, 3);
    const Surface surface(mesh, MendingOptions());
    EXPECT_TRUE(surface.provenance().isIdentity());
    EXPECT_EQ(&surface.input(), &surface.mesh());
    EXPECT_EQ(surface.faces(), mesh.faces);
}

TEST(Provenance, TellsWhatWasMendedAndKeepsTheInput) {
    const TriangleMesh mesh = bowTie();
    const Surface surface(mesh, MendingOptions());
    const Provenance& provenance = surface.provenance();
    EXPECT_EQ(surface.vertexCount(), 6);
    EXPECT_EQ(surface.input().vertices, mesh.vertices);
    EXPECT_EQ(surface.input().faces, mesh.faces);
    EXPECT_EQ(provenance.note(), "the mesh was mended: 1 vertex duplicated");
    EXPECT_EQ(provenance.refusal().value().code(), InputErrorCode::NonManifoldVertex);
    EXPECT_EQ(provenance.refusal().value().elements(), std::vector<std::int64_t>{0});
    const std::vector<double> values = {0, 1, 2, 3, 4};
    EXPECT_EQ(provenance.valuesOfInput(provenance.valuesFromInput(values)), values);
}

TEST(Surface, RefusesWhereItIsStrictOrNothingHelps) {
    const auto expect = [](const TriangleMesh& mesh, bool strict, InputErrorCode code) {
        expectRefused([&] { return Surface(mesh, MendingOptions{.strict = strict}); }, code);
    };
    expect(bowTie(), true, InputErrorCode::NonManifoldVertex);
    expect({}, false, InputErrorCode::EmptyMesh);
    expect(moebiusStrip(12), true, InputErrorCode::InconsistentOrientation);
    TriangleMesh flat = plate(1, 1);
    for (Vec3& vertex : flat.vertices) {
        vertex = Vec3::Zero();
    }
    expect(flat, false, InputErrorCode::DegenerateFace);
}

TEST(Surface, LeavesOutFacesThatAreNotFiniteWhereOthersStay) {
    TriangleMesh mesh = plate(2, 2);
    mesh.vertices[0].x() = std::numeric_limits<double>::quiet_NaN();
    for (const double weld : {0.0, 1e-6}) {
        const Surface surface(mesh, MendingOptions{.weld = weld});
        const RepairReport& report = *surface.provenance().report();
        EXPECT_FALSE(report.leftOutFaces.empty());
        EXPECT_EQ(report.leftOutFaces.size(), static_cast<std::size_t>(report.count()));
        EXPECT_EQ(surface.faces().size() + report.leftOutFaces.size(), mesh.faces.size());
        EXPECT_EQ(surface.vertices().size(), mesh.vertices.size());
    }
    mesh.faces.resize(1);
    expectRefused(
        [&] { return Surface(mesh, MendingOptions()); }, InputErrorCode::NonFiniteCoordinate
    );
}

TEST(Surface, SaysThatMendingHelpsWhereItDoes) {
    const auto remedyOf = [](const TriangleMesh& mesh) {
        const std::optional<InputError> error =
            refusal([&] { return Surface(mesh, MendingOptions{.strict = true}); });
        return error ? error->remedy().kind : Remedy::Kind::Weld;
    };
    EXPECT_EQ(remedyOf(bowTie()), Remedy::Kind::Mend);
    EXPECT_EQ(remedyOf({.vertices = {3, Vec3::Zero()}, .faces = {{0, 1, 2}}}), Remedy::Kind::None);
}

TEST(Surface, WeldsFirstWhereThatIsAsked) {
    // Two halves of a plate that share no vertex; one has moved a little.
    TriangleMesh half = plate(4, 2);
    for (Vec3& vertex : half.vertices) {
        vertex += Vec3(1.0, 1e-7, 0.0);
    }
    const TriangleMesh halves = joined(plate(4, 2), half);
    const auto weld = [&](double distance, bool strict = false) {
        return Surface(halves, MendingOptions{.strict = strict, .weld = distance});
    };
    const Surface apart = weld(1e-9);
    EXPECT_TRUE(apart.provenance().isIdentity());
    EXPECT_EQ(apart.componentCount(), 2);
    const Surface together = weld(1e-6);
    EXPECT_FALSE(together.provenance().refusal());
    EXPECT_EQ(together.componentCount(), 1);
    EXPECT_EQ(together.faceCount(), static_cast<int>(halves.faces.size()));
    EXPECT_EQ(together.provenance().report()->mergedVertices.size(), 3U);
    EXPECT_EQ(together.provenance().note(), "the mesh was mended: 3 vertices merged");
    expectRefused([&] { return weld(1e-6, true); }, InputErrorCode::BadOption);
}

/// A plate whose face 3 is turned over, and is there once more as the last face.
TriangleMesh plateWithTwin() {
    TriangleMesh mesh = withFaceReversed(plate(3, 3), 3);
    mesh.faces.push_back(mesh.faces[3]);
    return mesh;
}

// Splits are in repair_test.cpp.
TEST(Provenance, LeadsBackExactly) {
    const Surface surface(plateWithTwin(), MendingOptions());
    const Provenance& provenance = surface.provenance();
    for (const int face : {2, 3, 4}) {
        for (const Vec3& weights : {Vec3(0.1, 0.2, 0.7), Vec3(1e-13, 0.3, 0.7), Vec3(0, 1, 0)}) {
            const SurfacePoint point{.face = face, .barycentric = weights};
            const std::optional<SurfacePoint> back =
                provenance.fromInput(provenance.toInput(point));
            ASSERT_TRUE(back.has_value());
            EXPECT_EQ(back->face, face);
            EXPECT_EQ(back->barycentric, weights);
        }
    }
}

// Of two parts of face 0 the first has its corners in a line.
TEST(Provenance, LeavesPartsWithoutWidthAlone) {
    MeshRepair repair;
    repair.faceOrigins = {0, 0};
    const Vec3 middle(0.5, 0.5, 0.0);
    repair.changedCorners[0] << Vec3::UnitX(), middle, Vec3::UnitY();
    repair.changedCorners[1] << Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ();
    const std::optional<SurfacePoint> point =
        Provenance({}, repair, {}).fromInput({.face = 0, .barycentric = {0.2, 0.3, 0.5}});
    ASSERT_TRUE(point.has_value());
    EXPECT_EQ(point->face, 1);
    EXPECT_EQ(point->barycentric, Vec3(0.2, 0.3, 0.5));
}

TEST(Provenance, HasNothingInFacesThatWereRemoved) {
    const TriangleMesh mesh = plateWithTwin();
    const Surface surface(mesh, MendingOptions());
    const int twin = static_cast<int>(mesh.faces.size()) - 1;
    const SurfacePoint point{.face = twin, .barycentric = {0.2, 0.3, 0.5}};
    EXPECT_FALSE(surface.provenance().fromInput(point).has_value());
    SurfacePolyline line;
    line.surfacePoints = {{.face = 3, .barycentric = {0.2, 0.3, 0.5}}, point};
    line.points.resize(2);
    line.parameters = {0.0, 1.0};
    expectRefused(
        [&] { return strictLine(surface, line, "the line"); },
        InputErrorCode::NoPath,
        "left out of the mended",
        {{twin}}
    );
}

}  // namespace
}  // namespace bspline_curve
