// SPDX-License-Identifier: GPL-3.0-or-later
// Straightest geodesics against unfoldings: plate, prism and box.
#include "pattern/straightest_path.h"

#include "support/meshes.h"
#include "support/random.h"
#include "surface/strict_line.h"
#include "surface/surface_point.h"
#include "surface/triangle_tree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace bspline_curve {

namespace {

using namespace test_support;

constexpr double kExact = 1e-12;

/// A surface, and paths on it from where they are nearest to points.
struct Traced {
    explicit Traced(TriangleMesh mesh)
        : surface(std::move(mesh)), tree(surface.vertices(), surface.faces()) {}

    [[nodiscard]] SurfacePoint at(const Vec3& point) const {
        return snapped(tree.closestPoint(point).point, kOnEdgeBarycentric);
    }

    [[nodiscard]] StraightestPath from(
        const Vec3& start, const Vec3& direction, double length
    ) const {
        const SurfacePoint point = at(start);
        const SurfaceFan fan = fanOf(surface, point);
        const auto angle = angleOfDirection(surface, fan, direction);
        EXPECT_TRUE(angle.has_value());
        return straightestPath(surface, point, fan, angle.value_or(0.0), length);
    }

    [[nodiscard]] Vec3 endOf(const StraightestPath& path) const {
        return surface.position(path.points.back());
    }

    Surface surface;
    TriangleTree tree;
};

void expectStrict(const Surface& surface, const StraightestPath& path) {
    SurfacePolyline line;
    line.surfacePoints = path.points;
    EXPECT_TRUE(isStrict(surface, line));
}

void expectWholeAndAt(
    const Traced& scene, const StraightestPath& path, double length, const Vec3& end
) {
    EXPECT_TRUE(path.isWhole);
    EXPECT_NEAR(path.length, length, kExact);
    EXPECT_LT((scene.endOf(path) - end).norm(), kExact) << scene.endOf(path).transpose();
    expectStrict(scene.surface, path);
}

TEST(StraightestPath, IsStraightOnAPlaneWhateverTheFaces) {
    const Traced scene(jitteredPlate(9, 9, 0.25, 5));
    Random random(11);
    for (int i = 0; i < 300; ++i) {
        const Vec3 start(random.uniform(0.3, 0.7), random.uniform(0.3, 0.7), 0.0);
        const double angle = random.uniform(-std::numbers::pi, std::numbers::pi);
        const Vec3 direction(std::cos(angle), std::sin(angle), 0.0);
        const double length = random.uniform(0.0, 0.29);
        expectWholeAndAt(
            scene, scene.from(start, direction, length), length, start + length * direction
        );
    }
}

TEST(StraightestPath, IsStraightThroughVerticesAndAlongEdges) {
    const Traced scene(plate(8, 8));
    const double diagonal = std::sqrt(0.5);
    for (const Vec3& direction :
         {Vec3(1, 0, 0),
          Vec3(0, -1, 0),
          Vec3(diagonal, diagonal, 0),
          Vec3(-diagonal, diagonal, 0)}) {
        SCOPED_TRACE(testing::Message() << direction.transpose());
        const Vec3 vertex(0.5, 0.5, 0.0);
        expectWholeAndAt(scene, scene.from(vertex, direction, 0.4), 0.4, vertex + 0.4 * direction);
        const Vec3 onEdge = vertex + 0.03 * direction;
        expectWholeAndAt(scene, scene.from(onEdge, direction, 0.4), 0.4, onEdge + 0.4 * direction);
    }
}

TEST(StraightestPath, IsAHelixOnAPrism) {
    constexpr int kSegments = 12;
    const Traced scene(openCylinder(kSegments, 7));
    const double chord = 2.0 * std::sin(std::numbers::pi / kSegments);
    const double face = 2 * std::numbers::pi / kSegments;
    /// The point of the prism at a length of its perimeter.
    const auto folded = [&](double along, double height) {
        const double segment = std::floor(along / chord);
        const double share = along / chord - segment;
        const Vec3 a(std::cos(segment * face), std::sin(segment * face), height);
        const Vec3 b(std::cos((segment + 1) * face), std::sin((segment + 1) * face), height);
        return Vec3((1 - share) * a + share * b);
    };
    Random random(3);
    for (int i = 0; i < 100; ++i) {
        const double along = chord * (random.uniform(0.1, 0.9) + (i % kSegments));
        const double height = random.uniform(0.9, 1.1);
        const double slope = random.uniform(-0.2, 0.2);
        const double length = random.uniform(0.0, 4.0);
        const Vec3 start = folded(along, height);
        const Vec3 ahead = (folded(along + 1e-3, height) - start).normalized();
        const Vec3 direction = std::cos(slope) * ahead + std::sin(slope) * Vec3::UnitZ();
        expectWholeAndAt(
            scene,
            scene.from(start, direction, length),
            length,
            folded(along + std::cos(slope) * length, height + std::sin(slope) * length)
        );
    }
}

TEST(StraightestPath, GoesOverAnEdgeOfABoxAsOnItsNet) {
    const Traced scene(box(3));
    const double slope = 0.3;
    const Vec3 direction(std::cos(slope), std::sin(slope), 0.0);
    const Vec3 start(0.6, 0.45, 1.0);
    const Vec3 end(1.0, 0.45 + 0.9 * std::sin(slope), 1.0 - (0.6 + 0.9 * std::cos(slope) - 1.0));
    expectWholeAndAt(scene, scene.from(start, direction, 0.9), 0.9, end);
}

TEST(StraightestPath, LeavesACornerWithEqualAnglesOnBothSides) {
    for (const int cells : {1, 2, 5}) {
        const Traced scene(box(cells));
        const Vec3 start(0.55, 0.55, 1.0);
        const double toCorner = 0.45 * std::sqrt(2.0);
        // Down the edge between the two other sides.
        expectWholeAndAt(
            scene, scene.from(start, Vec3(1, 1, 0), toCorner + 0.3), toCorner + 0.3, {1, 1, 0.7}
        );
    }
}

TEST(StraightestPath, EndsAtTheBoundary) {
    const Traced scene(plate(5, 5));
    const StraightestPath path = scene.from({0.6, 0.5, 0.0}, {1, 0, 0}, 2.0);
    EXPECT_FALSE(path.isWhole);
    EXPECT_NEAR(path.length, 0.4, kExact);
    EXPECT_LT((scene.endOf(path) - Vec3(1, 0.5, 0)).norm(), kExact);
    const StraightestPath outwards = scene.from({0.6, 0.5, 0.0}, {0, 1, 0}, 0.4);
    EXPECT_TRUE(outwards.isWhole);
    EXPECT_FALSE(
        angleOfDirection(scene.surface, fanOf(scene.surface, scene.at({0.5, 1.0, 0.0})), {0, 1, 0})
            .has_value()
    );
}

TEST(StraightestPath, HasNoAngleOfTheNormal) {
    const Traced scene(box(2));
    const SurfaceFan fan = fanOf(scene.surface, scene.at({0.3, 0.4, 1.0}));
    EXPECT_FALSE(angleOfDirection(scene.surface, fan, {0, 0, 1}).has_value());
    EXPECT_TRUE(angleOfDirection(scene.surface, fan, {0.1, 0, 1}).has_value());
}

}  // namespace

}  // namespace bspline_curve
