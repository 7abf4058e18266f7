// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/close_chords.h"

#include "support/meshes.h"
#include "surface/surface.h"
#include "surface/triangle_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

/// A surface to lay paths on.
struct Ground {
    Surface surface;
    ExtendedSurface extended;
    TriangleTree tree;

    explicit Ground(TriangleMesh mesh)
        : surface(std::move(mesh)),
          extended(extendSurface(surface, 3)),
          tree(surface.vertices(), surface.faces()) {}

    /// Through the points of the surface nearest to some of the user's space.
    [[nodiscard]] std::vector<SurfacePoint> along(const std::vector<Vec3>& way) const {
        std::vector<SurfacePoint> path;
        for (const Vec3& point : way) {
            path.push_back(tree.closestPoint(point).point);
        }
        return path;
    }

    /// `distance`: in user units.
    [[nodiscard]] std::optional<std::vector<SurfacePoint>> close(
        const std::vector<SurfacePoint>& path, double distance
    ) const {
        return withCloseChords(extended, nullptr, path, distance / extended.frame.scale);
    }

    /// The farthest that midpoints of chords lie from the surface.
    [[nodiscard]] double farthest(const std::vector<SurfacePoint>& path) const {
        double most = 0.0;
        for (std::size_t i = 1; i < path.size(); ++i) {
            const Vec3 middle = 0.5 * (surface.position(path[i - 1]) + surface.position(path[i]));
            most = std::max(most, std::sqrt(tree.closestPoint(middle).squaredDistance));
        }
        return most;
    }
};

std::vector<Vec3> quarterOfCircle() {
    std::vector<Vec3> way;
    for (int i = 0; i <= 4; ++i) {
        const double angle = i * std::atan(1.0) / 2.0;
        way.emplace_back(std::cos(angle), std::sin(angle), 0.1);
    }
    return way;
}

TEST(CloseChords, LieWithinTheDistanceOfTheSurface) {
    const Ground ground(withNoise(icosphere(4), 0.01, 3));
    const std::vector<SurfacePoint> path = ground.along(quarterOfCircle());
    std::size_t before = path.size();
    for (const double distance : {1e-2, 1e-3, 1e-4}) {
        ASSERT_GT(ground.farthest(path), distance);
        const std::optional<std::vector<SurfacePoint>> close = ground.close(path, distance);
        ASSERT_TRUE(close.has_value());
        EXPECT_LE(ground.farthest(*close), distance);
        EXPECT_GT(close->size(), before) << distance;
        before = close->size();
    }
}

TEST(CloseChords, PassTheSamePointsInOrder) {
    const Ground ground(withNoise(icosphere(4), 0.01, 3));
    const std::vector<SurfacePoint> path = ground.along(quarterOfCircle());
    const std::optional<std::vector<SurfacePoint>> close = ground.close(path, 1e-3);
    ASSERT_TRUE(close.has_value());
    auto passed = close->begin();
    for (const SurfacePoint& point : path) {
        passed = std::find_if(passed, close->end(), [&](const SurfacePoint& other) {
            return other.face == point.face && other.barycentric == point.barycentric;
        });
        ASSERT_NE(passed, close->end());
    }
    EXPECT_EQ(passed + 1, close->end());
}

TEST(CloseChords, StayWholeWhereTheyAreClose) {
    const Ground ground(plate(20, 20));
    const std::vector<SurfacePoint> path =
        ground.along({{0.1, 0.2, 0.0}, {0.5, 0.7, 0.0}, {0.9, 0.1, 0.0}});
    const std::optional<std::vector<SurfacePoint>> close = ground.close(path, 1e-9);
    ASSERT_TRUE(close.has_value());
    EXPECT_EQ(close->size(), path.size());
}

TEST(CloseChords, AreNoneOverASlit) {
    const int cells = 21;
    TriangleMesh bent = plate(cells, cells);
    std::erase_if(bent.faces, [&](const Triangle& face) {
        Vec3 centre = Vec3::Zero();
        for (const int v : face) {
            centre += bent.vertices[v] / 3.0;
        }
        return std::abs(centre.x() - 0.5) < 0.5 / cells && std::abs(centre.y() - 0.5) < 0.2;
    });
    for (Vec3& vertex : bent.vertices) {
        vertex.z() = 0.5 * vertex.x() * vertex.x();
    }
    const Ground ground(std::move(bent));
    const auto across = [&](double y) { return ground.along({{0.2, y, 0.02}, {0.8, y, 0.32}}); };
    EXPECT_TRUE(ground.close(across(0.2), 1e-3).has_value());
    EXPECT_FALSE(ground.close(across(0.5), 1e-3).has_value());
}

// No chord from the lower side to the upper one can be close: each is halved on the lower side and
// leaves another one to halve.
TEST(CloseChords, EndAcrossAThinPlate) {
    const Ground ground(box(8, {1.0, 1.0, 0.01}));
    const std::vector<SurfacePoint> path = ground.along({{0.2, 0.3, 0.0}, {0.8, 0.6, 0.01}});
    const std::optional<std::vector<SurfacePoint>> close = ground.close(path, 1e-9);
    ASSERT_TRUE(close.has_value());
    EXPECT_EQ(close->size(), path.size() + 8);
}

}  // namespace
}  // namespace bspline_curve
