// SPDX-License-Identifier: GPL-3.0-or-later
// Where the boundary of a surface is, for nodes beside it.
#include "design/surface_walk.h"
#include "shell/extended_surface.h"
#include "surface/surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace bspline_curve {
namespace {

// A fan round the origin that is open by a notch so narrow that faces beyond its sides would
// overlap.
TriangleMesh fanWithNotch() {
    constexpr int kSpokes = 13;
    constexpr double kHalf = 1e-3;  // of the notch's angle
    TriangleMesh mesh;
    mesh.vertices.emplace_back(0.0, 0.0, 0.0);
    for (int i = 0; i < kSpokes; ++i) {
        const double angle = std::lerp(kHalf, 2.0 * std::numbers::pi - kHalf, i / (kSpokes - 1.0));
        mesh.vertices.emplace_back(std::cos(angle), std::sin(angle), 0.0);
        if (i > 0) {
            mesh.faces.push_back({0, i, i + 1});
        }
    }
    return mesh;
}

TEST(BoundaryGuard, KnowsTheBoundaryWhereNoFacesAreBeyondIt) {
    const Surface surface(fanWithNotch());
    const ExtendedSurface extended = extendSurface(surface, 3);
    const FibreProjector finder(extended);
    const BoundaryGuard guard(extended, finder);
    const auto nodeAt = [&](int face, const Vec3& barycentric) {
        SurfaceNode node;
        node.foot = FootPoint::at({face, barycentric});
        node.position = extended.position({face, barycentric});
        return node;
    };
    bool isAnyBare = false;
    for (int face = 0; face < surface.faceCount(); ++face) {
        for (int k = 0; k < 3; ++k) {
            EXPECT_TRUE(guard.isNear(nodeAt(face, Vec3::Unit(k)), 1e-9)) << face << ", " << k;
            if (surface.faceNeighbours()[face][k] < 0) {
                const Vec3 middle = 0.5 * (Vec3::Ones() - Vec3::Unit(k));
                EXPECT_LT(guard.distanceOf(nodeAt(face, middle)), 1e-12) << face << ", " << k;
                isAnyBare = isAnyBare || extended.faceNeighbours[face][k] < 0;
            }
        }
    }
    EXPECT_TRUE(isAnyBare);
}

}  // namespace
}  // namespace bspline_curve
