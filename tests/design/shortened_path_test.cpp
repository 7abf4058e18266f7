// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/shortened_path.h"

#include "support/meshes.h"
#include "surface/surface.h"
#include "surface/triangle_tree.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

/// A surface with the extended surface of its shell.
struct Ground {
    Surface surface;
    ExtendedSurface extended;
    TriangleTree tree;

    explicit Ground(TriangleMesh mesh)
        : surface(std::move(mesh)),
          extended(extendSurface(surface, 3)),
          tree(surface.vertices(), surface.faces()) {}

    /// The point of the surface nearest to a point of the user's space.
    [[nodiscard]] SurfacePoint nearest(const Vec3& user) const {
        return tree.closestPoint(user).point;
    }

    /// The points of the path pulled taut; none where it is refused.
    [[nodiscard]] std::vector<Vec3> taut(
        const std::vector<SurfacePoint>& path, const FieldTravel& travel = {}
    ) const {
        const std::optional<ShortenedPath> string = shortenPath(extended, nullptr, travel, path);
        return string ? positions(string->points) : std::vector<Vec3>{};
    }

    [[nodiscard]] std::vector<SurfacePoint> along(const std::vector<Vec3>& way) const {
        std::vector<SurfacePoint> path;
        for (const Vec3& point : way) {
            path.push_back(nearest(point));
        }
        return path;
    }

    [[nodiscard]] std::vector<Vec3> positions(const std::vector<SurfacePoint>& path) const {
        std::vector<Vec3> result;
        for (const SurfacePoint& point : path) {
            result.push_back(surface.position(point));
        }
        return result;
    }
};

/// From (1, 0, 0) to (cos(angle), sin(angle), 0) on the unit sphere, `aside` of it half way and
/// winding beside that.
std::vector<Vec3> windingWay(double angle, double aside, double winding) {
    std::vector<Vec3> way;
    for (int i = 0; i <= 40; ++i) {
        const double t = i / 40.0;
        const double z = aside * std::sin(std::numbers::pi * t) + (i % 2 == 1 ? winding : 0.0);
        way.push_back(Vec3(std::cos(angle * t), std::sin(angle * t), z).normalized());
    }
    return way;
}

TEST(TautPaths, LieOnGreatCircles) {
    const Ground ground(icosphere(5));
    for (const double angle : {0.5, 1.5, 2.5}) {
        SCOPED_TRACE(angle);
        const std::vector<Vec3> points = ground.taut(ground.along(windingWay(angle, 0.3, 0.05)));
        ASSERT_FALSE(points.empty());
        for (const Vec3& point : points) {
            EXPECT_LT(std::abs(point.z()), 2e-3);
        }
        for (std::size_t i = 1; i < points.size(); ++i) {
            EXPECT_NEAR((points[i] - points[i - 1]).norm() * 32.0 / angle, 1.0, 0.02);
        }
    }
}

TEST(TautPaths, HardlyDependOnTheWayThatTheyComeFrom) {
    const Ground ground(icosphere(5));
    const std::vector<Vec3> a = ground.taut(ground.along(windingWay(1.5, 0.3, 0.05)));
    const std::vector<Vec3> b = ground.taut(ground.along(windingWay(1.5, -0.2, 0.1)));
    ASSERT_EQ(std::min(a.size(), b.size()), 33U);
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_LT((a[i] - b[i]).norm(), 1e-3);
    }
}

TEST(TautPaths, FollowAValleyOfAField) {
    const Ground ground(plate(80, 80));
    const auto valley = [](double x) { return 0.5 + 0.1 * std::sin(2.0 * std::numbers::pi * x); };
    std::vector<double> costs;
    for (const Vec3& v : ground.surface.vertices()) {
        costs.push_back(std::min(1.0, std::abs(v.y() - valley(v.x())) / 0.1));
    }
    std::vector<Vec3> way;
    for (int i = 0; i <= 40; ++i) {
        const double x = 0.1 + 0.02 * i;
        way.emplace_back(x, valley(x) + (i % 2 == 0 ? 0.0 : 0.04), 0.0);
    }
    const std::vector<SurfacePoint> path = ground.along(way);
    const FieldTravel travel{costs, 10.0, 0.0};
    const std::vector<Vec3> taut = ground.taut(path, travel);
    ASSERT_FALSE(taut.empty());
    double aside = 0.0;
    for (const Vec3& point : taut) {
        aside += std::abs(point.y() - valley(point.x())) / static_cast<double>(taut.size());
    }
    EXPECT_LT(aside, 0.01);
    const std::vector<Vec3> straight = ground.taut(path);
    ASSERT_FALSE(straight.empty());
    for (const Vec3& point : straight) {
        const double share = (point.x() - way.front().x()) / 0.8;
        EXPECT_NEAR(point.y(), way.front().y() + share * (way.back().y() - way.front().y()), 1e-6);
    }
}

TEST(TautPaths, DoNotPassThroughAThinPlate) {
    const Ground ground(box(24, {1.0, 1.0, 0.01}));
    std::vector<Vec3> way;
    for (int i = 0; i <= 20; ++i) {
        way.emplace_back(0.7 + 0.3 * i / 20.0, 0.5, 0.01);
    }
    for (int i = 0; i <= 20; ++i) {
        way.emplace_back(1.0 - 0.3 * i / 20.0, 0.52, 0.0);
    }
    const std::optional<ShortenedPath> string =
        shortenPath(ground.extended, nullptr, {}, ground.along(way));
    double farthest = 0.0;
    if (string) {
        for (const Vec3& point : ground.positions(string->points)) {
            farthest = std::max(farthest, point.x());
        }
    }
    // None, or round the rim, or it says where it slipped through.
    EXPECT_TRUE(!string || farthest > 0.99 || !string->gaps.empty());
}

TEST(TautPaths, HaveGapsOnlyOverSharpEdges) {
    const Ground ground(wedge(100));
    const std::optional<ShortenedPath> string = shortenPath(
        ground.extended,
        nullptr,
        {},
        ground.along({{0.3, 0.4, 1.0}, {1.0, 0.5, 1.0}, {0.8, 0.6, 0.3}})
    );
    ASSERT_TRUE(string);
    const std::vector<Vec3> points = ground.positions(string->points);
    EXPECT_EQ(points.size(), 33U);
    ASSERT_EQ(string->gaps.size(), 1U);
    EXPECT_GT(points[string->gaps.front()].z(), 1.0 - 1e-9);
    EXPECT_LT(points[string->gaps.front() + 1].z(), 1.0 - 1e-9);
    const Ground sphere(icosphere(5));
    EXPECT_TRUE(shortenPath(sphere.extended, nullptr, {}, sphere.along(windingWay(1.5, 0.3, 0.05)))
                    ->gaps.empty());
}

TEST(TautPaths, AreRefusedWithoutTwoEndsApart) {
    const Ground ground(plate(4, 4));
    const SurfacePoint point = ground.nearest({0.4, 0.4, 0.0});
    EXPECT_FALSE(
        shortenPath(ground.extended, nullptr, {}, std::vector<SurfacePoint>{point, point})
    );
}

}  // namespace
}  // namespace bspline_curve
