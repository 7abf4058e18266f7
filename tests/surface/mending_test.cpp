// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/mending.h"

#include "bspline_curve/error.h"
#include "support/meshes.h"
#include "surface/surface.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

Mended<Surface> mendedSurface(const TriangleMesh& mesh, bool strict) {
    return makeMended(mesh, strict, [](TriangleMesh given) { return Surface(std::move(given)); });
}

TEST(Surface, GivesAMeshThatItRefusesBackAsItWas) {
    for (const TriangleMesh& broken : {threeFacesAtAnEdge(), bowTie(), moebiusStrip(12)}) {
        try {
            static_cast<void>(Surface(broken));
            FAIL() << "it was accepted";
        } catch (RefusedMesh& refused) {
            const TriangleMesh mesh = refused.takeMesh();
            EXPECT_EQ(mesh.vertices, broken.vertices);
            EXPECT_EQ(mesh.faces, broken.faces);
        }
    }
}

TEST(MakeMended, TakesASoundMeshAsItIs) {
    const TriangleMesh mesh = plate(3, 3);
    const Mended<Surface> mended = mendedSurface(mesh, false);
    EXPECT_FALSE(mended.mending);
    EXPECT_EQ(mended.made.faces(), mesh.faces);
}

TEST(MakeMended, MendsWhatIsBrokenAndTellsWhatItWas) {
    const Mended<Surface> mended = mendedSurface(bowTie(), false);
    ASSERT_TRUE(mended.mending);
    EXPECT_EQ(mended.made.vertexCount(), 6);
    EXPECT_EQ(mended.mending->note(), "the mesh was mended: 1 vertex duplicated");
    EXPECT_EQ(mended.mending->refusal.code(), InputErrorCode::NonManifoldVertex);
    EXPECT_EQ(mended.mending->refusal.elements(), std::vector<std::int64_t>{0});
}

TEST(MakeMended, RefusesWhereItIsStrictOrNothingHelps) {
    const auto codeOf = [](const TriangleMesh& mesh, bool strict) {
        try {
            static_cast<void>(mendedSurface(mesh, strict));
        } catch (const InputError& error) {
            return error.code();
        }
        throw std::logic_error("it was accepted");
    };
    EXPECT_EQ(codeOf(bowTie(), true), InputErrorCode::NonManifoldVertex);
    EXPECT_EQ(codeOf({}, false), InputErrorCode::EmptyMesh);
    EXPECT_EQ(codeOf(moebiusStrip(12), true), InputErrorCode::InconsistentOrientation);
    TriangleMesh flat = plate(1, 1);
    for (Vec3& vertex : flat.vertices) {
        vertex = Vec3::Zero();
    }
    EXPECT_EQ(codeOf(flat, false), InputErrorCode::DegenerateFace);
}

TEST(MakeMended, BringsValuesBackToTheGivenVertices) {
    const Mended<Surface> mended = mendedSurface(bowTie(), false);
    const std::vector<double> given = {0, 1, 2, 3, 4};
    EXPECT_EQ(mended.mending->toOrigin(mended.repair()->carriedOver(given)), given);
}

}  // namespace
}  // namespace bspline_curve
