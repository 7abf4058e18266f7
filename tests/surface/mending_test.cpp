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
    return makeMended(mesh, {.strict = strict}, [](TriangleMesh given) {
        return Surface(std::move(given));
    });
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
    EXPECT_EQ(mended.mending->refusal.value().code(), InputErrorCode::NonManifoldVertex);
    EXPECT_EQ(mended.mending->refusal.value().elements(), std::vector<std::int64_t>{0});
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

TEST(MakeMended, WeldsFirstWhereThatIsAsked) {
    // Two halves of a plate that share no vertex; one has moved a little.
    TriangleMesh halves = plate(4, 2);
    const int count = static_cast<int>(halves.vertices.size());
    for (int v = 0; v < count; ++v) {
        halves.vertices.push_back(halves.vertices[v] + Vec3(1.0, 1e-7, 0.0));
    }
    for (std::size_t f = 0, n = halves.faces.size(); f < n; ++f) {
        const auto [a, b, c] = halves.faces[f];
        halves.faces.push_back({a + count, b + count, c + count});
    }
    const auto weld = [&](double distance) {
        return makeMended(halves, {.weld = distance}, [](TriangleMesh given) {
            return Surface(std::move(given));
        });
    };
    const Mended<Surface> apart = weld(1e-9);
    EXPECT_FALSE(apart.mending);
    EXPECT_EQ(apart.made.componentCount(), 2);
    const Mended<Surface> joined = weld(1e-6);
    ASSERT_TRUE(joined.mending);
    EXPECT_FALSE(joined.mending->refusal);
    EXPECT_EQ(joined.made.componentCount(), 1);
    EXPECT_EQ(joined.made.faceCount(), static_cast<int>(halves.faces.size()));
    EXPECT_EQ(joined.repair()->report.mergedVertices.size(), 3U);
    EXPECT_EQ(joined.mending->note(), "the mesh was mended: 3 vertices merged");
    EXPECT_THROW(
        static_cast<void>(makeMended(
            halves,
            {.strict = true, .weld = 1e-6},
            [](TriangleMesh given) { return Surface(std::move(given)); }
        )),
        InputError
    );
}

TEST(MakeMended, BringsValuesBackToTheGivenVertices) {
    const Mended<Surface> mended = mendedSurface(bowTie(), false);
    const std::vector<double> given = {0, 1, 2, 3, 4};
    EXPECT_EQ(mended.mending->toOrigin(mended.repair()->carriedOver(given)), given);
}

}  // namespace
}  // namespace bspline_curve
