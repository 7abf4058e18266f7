// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/distance_to_region.h"

#include "support/meshes.h"
#include "support/places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace bspline_curve {
namespace {

using namespace test_support;

Region facesWithin(const Surface& surface, const Vec3& centre, double radius) {
    Region region;
    for (int f = 0; f < surface.faceCount(); ++f) {
        const Triangle& corners = surface.faces()[f];
        if (std::ranges::all_of(corners, [&](int v) {
                return (surface.vertices()[v] - centre).norm() <= radius;
            })) {
            region.push_back(f);
        }
    }
    return region;
}

TEST(DistanceToRegion, IsExactBeforeAStraightEdge) {
    const Surface even(plate(20, 20));
    const Region column = facesWhere(even, [](const Vec3& p) { return p.x() < 0.05; });
    const std::vector<double> distances = distancesToRegion(even, column, 0.5);
    for (std::size_t v = 0; v < distances.size(); ++v) {
        const double expected = std::clamp(even.vertices()[v].x() - 0.05, 0.0, 0.5);
        EXPECT_NEAR(distances[v], expected, 1e-12) << "vertex " << v;
    }
}

TEST(DistanceToRegion, IsWithinASeventhOutsideADisc) {
    const Surface surface(jitteredPlate(60, 60, 0.25, 5));
    const Vec3 centre(0.5, 0.5, 0);
    const Region disc = facesWithin(surface, centre, 0.15);
    const std::vector<double> distances = distancesToRegion(surface, disc, 0.3);
    for (std::size_t v = 0; v < distances.size(); ++v) {
        double expected = 0.3;
        for (const int f : disc) {
            for (const int w : surface.faces()[f]) {
                const Vec3& corner = surface.vertices()[w];
                expected = std::min(expected, (surface.vertices()[v] - corner).norm());
            }
        }
        // Edges of the disc may be nearer than its corners, by less than their length.
        EXPECT_LT(distances[v], 1.15 * expected + 1e-12) << "vertex " << v;
        EXPECT_GT(distances[v], 0.85 * expected - 0.01) << "vertex " << v;
    }
}

TEST(DistanceToRegion, FollowsTheSurface) {
    // Round a thin box: the far side is near in space and far along the surface.
    const Surface surface(box(10, Vec3(1, 1, 0.02)));
    const Region top = facesWhere(surface, [](const Vec3& p) {
        return p.z() > 0.0199 && (p - Vec3(0.5, 0.5, 0.02)).norm() < 0.2;
    });
    ASSERT_FALSE(top.empty());
    const std::vector<double> distances = distancesToRegion(surface, top, 0.25);
    for (std::size_t v = 0; v < distances.size(); ++v) {
        if (surface.vertices()[v].z() == 0.0) {
            EXPECT_EQ(distances[v], 0.25) << "vertex " << v;
        }
    }
}

}  // namespace
}  // namespace bspline_curve
