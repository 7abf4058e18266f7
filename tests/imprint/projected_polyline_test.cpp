// SPDX-License-Identifier: GPL-3.0-or-later
#include "imprint/projected_polyline.h"

#include "support/many_cases.h"
#include "support/meshes.h"
#include "support/refusal.h"
#include "support/seeds.h"
#include "surface/strict_line.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace bspline_curve {
namespace {

using namespace test_support;

struct Target {
    explicit Target(const TriangleMesh& mesh) : surface(mesh) {}

    [[nodiscard]] SurfacePolyline project(
        const std::vector<Vec3>& points, bool closed, double distance
    ) const {
        return projectedPolyline(surface, tree, {.points = points, .closed = closed}, distance);
    }

    Surface surface;
    TriangleTree tree{surface.vertices(), surface.faces()};
};

TEST(ProjectedPolyline, IsTheFootOfSegmentsOverAPlate) {
    const Target plate(test_support::plate(9, 9));
    const SurfacePolyline line =
        plate.project({{0.1, 0.2, 0.01}, {0.8, 0.3, -0.01}, {0.5, 0.9, 0.0}}, true, 0.02);
    EXPECT_TRUE(isStrict(plate.surface, line));
    EXPECT_TRUE(line.closed);
    for (const Vec3& point : line.points) {
        EXPECT_EQ(point.z(), 0.0);
    }
    const double expected = std::hypot(0.7, 0.1) + std::hypot(0.3, 0.6) + std::hypot(0.4, 0.7);
    EXPECT_NEAR(lengthOf(line), expected, 1e-3);
    EXPECT_EQ(line.parameters.front(), 0.0);
    EXPECT_LT(line.parameters.back(), 1.0);
}

TEST(ProjectedPolyline, FollowsASphereWithinTheDistance) {
    const Target sphere(icosphere(4));
    std::vector<Vec3> circle;
    constexpr int kCount = 40;
    for (int i = 0; i < kCount; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / kCount;
        circle.emplace_back(0.8 * std::cos(angle), 0.8 * std::sin(angle), 0.6);
    }
    const SurfacePolyline line = sphere.project(circle, true, 0.01);
    EXPECT_TRUE(isStrict(sphere.surface, line));
    EXPECT_NEAR(lengthOf(line), 1.6 * std::numbers::pi, 0.01);
    for (const Vec3& point : line.points) {
        EXPECT_NEAR(point.z(), 0.6, 0.01);
    }
    expectRefused(
        [&] { return sphere.project(circle, true, 1e-4); },
        InputErrorCode::PickTooFar,
        "away from the mesh"
    );
}

TEST(ProjectedPolyline, RefusesWhatLeavesTheMeshOrChangesItsPart) {
    const Target plates(joined(
        plate(4, 4),
        transformed(plate(4, 4), Eigen::Isometry3d(Eigen::Translation3d(1.01, 0, 0)), 1.0)
    ));
    expectRefused(
        [&] { return plates.project({{0.5, 0.5, 0}, {0.5, 0.6, 0}, {0.5, 0.7, 3}}, false, 0.1); },
        InputErrorCode::PickTooFar,
        "vertex 2",
        std::vector<std::int64_t>{2}
    );
    expectRefused(
        [&] { return plates.project({{0.5, 0.5, 0}, {1.5, 0.5, 0}}, false, 0.1); },
        InputErrorCode::NoPath,
        "gap"
    );
    expectRefused(
        [&] { return plates.project({{0.5, 0.5, 0}, {0.5, 0.5, 0}}, false, 0.1); },
        InputErrorCode::NoPath,
        "one point"
    );
}

TEST(ProjectedPolyline, IsStrictForRandomPolylines) {
    for (const TriangleMesh& mesh : {icosphere(2), torus(14, 9), box(3)}) {
        const Target target(mesh);
        const double reach = target.surface.diagonal();
        forEachSeed(caseCount(50, 5), [&](Random& random) {
            std::vector<Vec3> points;
            for (int i = 0; i < 6; ++i) {
                points.emplace_back(
                    random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)
                );
            }
            const SurfacePolyline line = target.project(points, true, reach);
            ASSERT_TRUE(isStrict(target.surface, line));
        });
    }
}

}  // namespace
}  // namespace bspline_curve
