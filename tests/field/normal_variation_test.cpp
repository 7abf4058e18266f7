// SPDX-License-Identifier: GPL-3.0-or-later
#include "field/normal_variation.h"

#include "support/meshes.h"
#include "support/random.h"
#include "surface/vertex_normals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace bspline_curve {
namespace {

using namespace test_support;

// The normal of an edge between two sides makes 45 degrees with both, that of a corner between
// three the angle whose cosine is 1 / sqrt(3).
TEST(NormalVariation, OfABoxHasThreeValues) {
    const TriangleMesh mesh = transformed(box(4), Random(1).isometry(3.0), 1e-3);
    const TriangleMesh straight = box(4);
    const auto values = normalVariation(Surface(mesh));
    for (std::size_t i = 0; i < values.size(); ++i) {
        int sides = 0;
        for (const double x : straight.vertices[i]) {
            sides += x == 0.0 || x == 1.0 ? 1 : 0;
        }
        EXPECT_NEAR(values[i], 1.0 / std::sqrt(sides), 1e-12) << i;
    }
}

TEST(NormalVariation, GrowsSmallerWithFinerMeshesOfASphere) {
    // Faces around a vertex turn by half the angle of an edge at most: 1 - h^2 / 8 to 1 - h^2 / 2.
    for (const int subdivisions : {3, 4, 5}) {
        const Surface surface(icosphere(subdivisions));
        const double h = surface.averageEdgeLength();
        const auto values = normalVariation(surface);
        EXPECT_GT(*std::ranges::min_element(values), 1.0 - 0.5 * h * h);
        EXPECT_LT(*std::ranges::max_element(values), 1.0 - 0.1 * h * h);
    }
}

TEST(NormalVariation, IsOneWithoutFaces) {
    TriangleMesh mesh = plate(2, 2);
    mesh.vertices.emplace_back(7, 7, 7);
    EXPECT_EQ(normalVariation(Surface(mesh)), std::vector<double>(10, 1.0));
    EXPECT_EQ(vertexNormals(mesh).back(), Vec3::Zero());
}

// The minimum over faces that are nearly opposite: a blade.
TEST(NormalVariation, IsNearZeroAtASharpBlade) {
    const Surface surface(
        {.vertices = {{0, 0, 0}, {0, 1, 0}, {1, 0.5, 0.01}, {1, 0.5, -0.01}},
         .faces = {{0, 2, 1}, {0, 1, 3}}}
    );
    const auto values = normalVariation(surface);
    EXPECT_NEAR(values[0], 0.01, 1e-4);
    EXPECT_NEAR(values[2], 1.0, 1e-12);
}

}  // namespace
}  // namespace bspline_curve
