// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/surface_point.h"

#include "support/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

TEST(SurfacePoints, AreHeldByTheirFaceTheNeighbourOrTheStar) {
    const Surface surface(icosphere(2));
    for (int f = 0; f < surface.faceCount(); f += 7) {
        const Triangle& face = surface.faces()[f];
        EXPECT_EQ(facesHolding(surface, {f, {0.2, 0.3, 0.5}}), std::vector<int>{f});
        std::vector<int> pair{f, surface.faceNeighbours()[f][1]};
        std::ranges::sort(pair);
        EXPECT_EQ(facesHolding(surface, {f, {0.4, 0.0, 0.6}}), pair);
        const Surface::FaceRange around = surface.facesAround(face[2]);
        std::vector<int> star(around.begin(), around.end());
        std::ranges::sort(star);
        EXPECT_EQ(facesHolding(surface, {f, Vec3::UnitZ()}), star);
        for (const int g : star) {
            const Vec3 same = surface.position(inFace(surface, {f, Vec3::UnitZ()}, g));
            EXPECT_LT((same - surface.vertices()[face[2]]).norm(), 1e-15);
        }
    }
}

TEST(SurfacePoints, SnapToTheEdgeOrVertexTheyAreNear) {
    const SurfacePoint edge = snapped({0, {1e-10, 0.4, 0.6 - 1e-10}}, 1e-9);
    EXPECT_EQ(edge.barycentric[0], 0.0);
    EXPECT_NEAR(edge.barycentric.sum(), 1.0, 1e-15);
    EXPECT_EQ(snapped({0, {1e-10, 1.0 - 2e-10, 1e-10}}, 1e-9).barycentric, Vec3::UnitY());
    const Vec3 inner(0.2, 0.3, 0.5);
    EXPECT_EQ(snapped({0, inner}, 1e-9).barycentric, inner);
}

}  // namespace
}  // namespace bspline_curve
