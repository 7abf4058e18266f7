// SPDX-License-Identifier: GPL-3.0-or-later
// Planes carried to surfaces: exact on the plane, near great circles on the sphere.
#include "design/curve_designer.h"
#include "pattern/curve_chart.h"
#include "pattern/point_chart.h"
#include "support/meshes.h"
#include "support/refusal.h"
#include "surface/surface_point.h"
#include "surface/triangle_tree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace bspline_curve {

namespace {

using namespace test_support;
using Vec2 = Eigen::Vector2d;
using Status = CarriedPoint::Status;

SurfacePoint nearest(const Surface& surface, const Vec3& point) {
    const TriangleTree tree(surface.vertices(), surface.faces());
    return snapped(tree.closestPoint(point).point, kOnEdgeBarycentric);
}

Vec3 carried(const Surface& surface, const SurfaceChart& chart, const Vec2& point) {
    const CarriedPoint result = chart.at(point);
    EXPECT_EQ(result.status, Status::OnSurface) << point.transpose();
    return result.status == Status::OnSurface ? surface.position(result.point) : Vec3(Vec3::Zero());
}

SurfacePolyline drawn(const TriangleMesh& mesh, const std::vector<Vec3>& picks, bool closed) {
    SolverOptions options;
    options.closed = closed;
    return CurveDesigner(mesh).design(picks, options).polyline;
}

TEST(PointChart, IsTheIdentityOnAPlane) {
    const Surface surface(jitteredPlate(12, 12, 0.25, 2));
    // In a face, on an edge and on a vertex.
    const Vec3 corner = surface.vertices()[6 * 13 + 6];
    const Vec3 next = surface.vertices()[6 * 13 + 7];
    for (const Vec3& centre : {Vec3(0.51, 0.52, 0.0), corner, Vec3(0.5 * (corner + next))}) {
        const PointChart chart(surface, nearest(surface, centre), Vec3::UnitY());
        for (int i = 0; i < 50; ++i) {
            const Vec2 point = 0.008 * i * Vec2(std::cos(i), std::sin(i));
            const Vec3 expected = centre + Vec3(point.x(), point.y(), 0.0);
            EXPECT_LT((carried(surface, chart, point) - expected).norm(), 1e-12);
        }
    }
}

TEST(PointChart, TurnsTheDrawingUpwards) {
    const Surface surface(plate(7, 7));
    const Vec3 centre(0.52, 0.47, 0.0);
    const PointChart chart(surface, nearest(surface, centre), Vec3(1, 1, 5));
    const Vec3 up = centre + 0.2 * Vec3(1, 1, 0).normalized();
    EXPECT_LT((carried(surface, chart, {0.0, 0.2}) - up).norm(), 1e-12);
    const Vec3 right = centre + 0.2 * Vec3(1, -1, 0).normalized();
    EXPECT_LT((carried(surface, chart, {0.2, 0.0}) - right).norm(), 1e-12);
}

TEST(PointChart, FollowsGreatCirclesOnASphere) {
    const Surface surface(icosphere(5));
    const Vec3 centre = Vec3(0.3, 0.5, 0.8).normalized();
    const Vec3 up = (Vec3::UnitY() - Vec3::UnitY().dot(centre) * centre).normalized();
    const Vec3 right = up.cross(centre);
    const PointChart chart(surface, nearest(surface, centre), Vec3::UnitY());
    for (int i = 0; i < 60; ++i) {
        const double radius = 0.02 * i;
        const Vec3 direction = std::cos(i) * right + std::sin(i) * up;
        const Vec3 expected = std::cos(radius) * centre + std::sin(radius) * direction;
        const Vec2 point = radius * Vec2(std::cos(i), std::sin(i));
        EXPECT_LT((carried(surface, chart, point) - expected).norm(), 0.01) << radius;
    }
}

TEST(PointChart, ScalesTheAnglesAtACorner) {
    const Surface surface(box(2));
    const PointChart chart(surface, nearest(surface, {1, 1, 1}), Vec3(-1, -1, 1));
    // Three right angles share a full turn.
    const Vec3 up = carried(surface, chart, {0.0, 0.3});
    for (const double turn : {2 * std::numbers::pi / 3, 4 * std::numbers::pi / 3}) {
        const Vec3 turned = carried(surface, chart, 0.3 * Vec2(-std::sin(turn), std::cos(turn)));
        EXPECT_NEAR(turned.minCoeff(), up.minCoeff(), 1e-12);
        EXPECT_NEAR(turned.maxCoeff(), up.maxCoeff(), 1e-12);
        EXPECT_GT((turned - up).norm(), 0.1);
    }
}

TEST(PointChart, TellsWhatIsBeyondTheBoundary) {
    const Surface surface(plate(4, 4));
    const PointChart chart(surface, nearest(surface, {0.5, 0.5, 0}), Vec3::UnitY());
    EXPECT_EQ(chart.at({0.0, 0.6}).status, Status::BeyondBoundary);
    EXPECT_EQ(chart.at({0.6, 0.6}).status, Status::BeyondBoundary);
    expectRefused(
        [&] { return PointChart(surface, nearest(surface, {0.5, 0.5, 0}), Vec3::UnitZ()).at({}); },
        InputErrorCode::BadOption,
        "normal"
    );
}

TEST(CurveChart, IsTheIdentityAlongAStraightCurve) {
    const TriangleMesh mesh = jitteredPlate(12, 12, 0.25, 4);
    const Surface surface(mesh);
    const SurfacePolyline line = drawn(mesh, {{0.2, 0.3, 0}, {0.8, 0.7, 0}}, false);
    const CurveChart chart(surface, line, surface.averageEdgeLength());
    const Vec3 along = Vec3(0.6, 0.4, 0).normalized();
    const Vec3 left(-along.y(), along.x(), 0.0);
    EXPECT_NEAR(chart.length(), std::sqrt(0.52), 1e-9);
    for (int i = 0; i <= 40; ++i) {
        const double x = chart.length() * i / 40;
        const double y = 0.15 * std::sin(i);
        const Vec3 expected = Vec3(0.2, 0.3, 0) + x * along + y * left;
        EXPECT_LT((carried(surface, chart, {x, y}) - expected).norm(), 1e-6);
    }
    EXPECT_EQ(chart.at({-0.01, 0.0}).status, Status::BeyondCurve);
    EXPECT_EQ(chart.at({chart.length() + 0.01, 0.0}).status, Status::BeyondCurve);
    EXPECT_EQ(chart.at({0.1, 0.9}).status, Status::BeyondBoundary);
}

TEST(CurveChart, BendsWithACircle) {
    const TriangleMesh mesh = jitteredPlate(15, 15, 0.25, 6);
    const Surface surface(mesh);
    const double radius = 0.25;
    std::vector<Vec3> picks;
    for (int i = 0; i < 24; ++i) {
        const double angle = 2 * std::numbers::pi * i / 24;
        picks.emplace_back(0.5 + radius * std::cos(angle), 0.5 + radius * std::sin(angle), 0.0);
    }
    const SurfacePolyline line = drawn(mesh, picks, true);
    for (const double smoothing : {0.0, 0.05}) {
        const CurveChart chart(surface, line, smoothing);
        ASSERT_TRUE(chart.closed());
        for (int i = 0; i < 100; ++i) {
            const double turn = -0.3 + 0.1 * i;  // also before the start and past the end
            const double y = 0.2 * std::sin(3 * i);
            const double angle = 2 * std::numbers::pi * turn;
            const Vec3 expected =
                Vec3(0.5, 0.5, 0) + (radius - y) * Vec3(std::cos(angle), std::sin(angle), 0);
            const Vec3 found = carried(surface, chart, {turn * chart.length(), y});
            EXPECT_LT((found - expected).norm(), smoothing == 0.0 ? 4e-3 : 5e-4)
                << turn << ' ' << y;
        }
    }
}

TEST(CurveChart, RunsAlongABoundary) {
    const Surface surface(plate(6, 6));
    SurfacePolyline line;
    for (int i = 0; i <= 6; ++i) {
        line.surfacePoints.push_back(nearest(surface, {i / 6.0, 0.0, 0.0}));
        line.points.push_back(surface.position(line.surfacePoints.back()));
        line.parameters.push_back(i / 6.0);
    }
    const CurveChart chart(surface, line, 0.1);
    for (int i = 1; i < 30; ++i) {
        const double x = i / 30.0;
        EXPECT_LT((carried(surface, chart, {x, 0.4}) - Vec3(x, 0.4, 0)).norm(), 1e-9) << x;
        EXPECT_EQ(chart.at({x, -0.1}).status, Status::BeyondBoundary);
    }
}

}  // namespace

}  // namespace bspline_curve
