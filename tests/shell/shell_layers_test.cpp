// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/shell_layers.h"

#include "built_shell.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace bspline_curve {
namespace {

using namespace test_support;

// Expects a sphere about the origin between the layers.
void expectAround(const ShellLayers& layers, double radius) {
    for (const Vec3& vertex : layers.top.vertices) {
        EXPECT_GT(vertex.norm(), radius);
    }
    for (const Vec3& vertex : layers.bottom.vertices) {
        EXPECT_LT(vertex.norm(), radius);
    }
}

TEST(ShellLayers, EncloseAClosedSurface) {
    const BuiltShell built(icosphere(3, 5.0));
    const ShellLayers layers = makeShellLayers(built.shell(), built.extended.frame);
    for (const TriangleMesh* const layer : {&layers.top, &layers.bottom}) {
        const Surface surface(*layer);  // a closed manifold, oriented
        EXPECT_EQ(surface.faceCount(), built.surface.faceCount());
        EXPECT_GT(surface.faceNormal(0).dot(layer->vertices[0]), 0.0) << "outwards";
    }
    expectAround(layers, 5.0);
}

TEST(ShellLayers, LieOnTheirSidesOfAPlateAndReachBeyondItsBoundary) {
    const BuiltShell built(plate(6, 6));
    const ShellLayers layers = makeShellLayers(built.shell(), built.extended.frame);
    double least = 1.0;
    for (const Vec3& vertex : layers.top.vertices) {
        EXPECT_GT(vertex.z(), 0.0);
        least = std::min(least, vertex.x());
    }
    EXPECT_LT(least, 0.0);
    for (const Vec3& vertex : layers.bottom.vertices) {
        EXPECT_LT(vertex.z(), 0.0);
    }
    EXPECT_GT(layers.top.faces.size(), built.surface.faces().size());
}

TEST(ShellLayers, HaveHolesWherePrismsAreBlocked) {
    const BuiltShell built(crossingPlates());
    ASSERT_FALSE(built.blockedFaces().empty());
    const ShellLayers layers = makeShellLayers(built.shell(), built.extended.frame);
    const auto prismCount =
        std::ranges::count_if(built.shell().prisms(), [](auto& p) { return p.orientation != 0; });
    EXPECT_EQ(std::ssize(layers.top.faces), prismCount);
}

TEST(ShellLayers, OfASimplifiedShellAreFewerFacesAroundTheSurface) {
    const SimplifiedShell built(icosphere(3));
    const ShellLayers layers = makeShellLayers(built.shell(), built.extended.frame);
    EXPECT_LT(layers.top.faces.size(), built.surface.faces().size());
    expectAround(layers, 1.0);
}

}  // namespace
}  // namespace bspline_curve
