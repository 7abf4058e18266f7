// SPDX-License-Identifier: GPL-3.0-or-later
#include "imprint/draped_polyline.h"

#include "imprint/projected_polyline.h"
#include "support/many_cases.h"
#include "support/meshes.h"
#include "support/refusal.h"
#include "support/seeds.h"
#include "surface/strict_line.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

const Vec3 kDown(0, 0, -1);

struct DrapeTarget {
    explicit DrapeTarget(const TriangleMesh& mesh) : surface(mesh) {}

    [[nodiscard]] ProjectedLines drape(
        const std::vector<Vec3>& points,
        bool closed = false,
        const Vec3& direction = kDown,
        double distance = 0.0
    ) const {
        return projectedLines(
            surface,
            tree,
            {.points = points, .closed = closed},
            {.distance = distance, .direction = direction}
        );
    }

    Surface surface;
    TriangleTree tree{surface.vertices(), surface.faces()};
};

/// A plate whose columns of vertices are at these places.
TriangleMesh profile(const std::vector<std::array<double, 2>>& xz, int rows) {
    TriangleMesh mesh = plate(static_cast<int>(xz.size()) - 1, rows);
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const auto& [x, z] = xz[i % xz.size()];
        mesh.vertices[i].x() = x;
        mesh.vertices[i].z() = z;
    }
    return mesh;
}

Vec3 beside(const Vec3& point, const Vec3& direction) {
    return point - direction.dot(point) * direction;
}

double distanceBeside(const Vec3& point, const Vec3& a, const Vec3& b, const Vec3& direction) {
    const Vec3 p = beside(point - a, direction);
    const Vec3 way = beside(b - a, direction);
    const double share =
        way.isZero(0.0) ? 0.0 : std::clamp(p.dot(way) / way.squaredNorm(), 0.0, 1.0);
    return (p - share * way).norm();
}

TEST(DrapedPolyline, HasTheVerticesOfTheLineAndTheCrossingsOfEdgesToRounding) {
    TriangleMesh hill = plate(9, 9);
    for (Vec3& vertex : hill.vertices) {
        vertex.z() = 3.0 * std::sin(5.0 * vertex.x()) * std::cos(4.0 * vertex.y());
    }
    const DrapeTarget target(hill);
    const std::vector<Vec3> plan{{0.11, 0.23, 7}, {0.87, 0.31, -5}, {0.42, 0.93, 0}};
    const ProjectedLines draped = target.drape(plan, true);
    ASSERT_EQ(draped.lines.size(), 1U);
    EXPECT_TRUE(draped.gaps.empty());
    EXPECT_TRUE(draped.jumps.empty());
    const SurfacePolyline& line = draped.lines.front();
    EXPECT_TRUE(line.closed);
    EXPECT_TRUE(isStrict(target.surface, line));
    std::size_t found = 0;
    for (const Vec3& point : line.points) {
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < plan.size(); ++i) {
            nearest = std::min(nearest, distanceBeside(point, plan[i], plan[(i + 1) % 3], kDown));
            found += (beside(point - plan[i], kDown).norm() < 1e-14) ? 1 : 0;
        }
        EXPECT_LT(nearest, 1e-14);
    }
    EXPECT_EQ(found, plan.size());
    // As many vertices as edges are crossed, and no samples between.
    for (std::size_t i = 0; i < line.points.size(); ++i) {
        const bool isInFace = line.surfacePoints[i].barycentric.minCoeff() > 1e-9;
        const bool isOfPlan = std::ranges::any_of(plan, [&](const Vec3& vertex) {
            return beside(line.points[i] - vertex, kDown).norm() < 1e-14;
        });
        EXPECT_TRUE(!isInFace || isOfPlan) << i;
    }
}

TEST(DrapedPolyline, FallsOnTheSideThatTheDirectionComesFrom) {
    const DrapeTarget sphere(icosphere(3));
    std::vector<Vec3> circle;
    constexpr int kCount = 24;
    for (int i = 0; i < kCount; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / kCount;
        circle.emplace_back(0.5 * std::cos(angle), 0.5 * std::sin(angle), 0.1);
    }
    for (const double side : {1.0, -1.0}) {
        const ProjectedLines draped = sphere.drape(circle, true, {0, 0, -side});
        ASSERT_EQ(draped.lines.size(), 1U);
        EXPECT_TRUE(draped.lines.front().closed);
        for (const Vec3& point : draped.lines.front().points) {
            EXPECT_GT(side * point.z(), 0.8);
        }
    }
}

TEST(DrapedPolyline, EndsAtTheBoundaryWhereItLeavesTheMesh) {
    const DrapeTarget target(plate(7, 7));
    const ProjectedLines across = target.drape({{-0.5, 0.4, 1}, {1.5, 0.6, 1}});
    ASSERT_EQ(across.lines.size(), 1U);
    EXPECT_EQ(across.gaps, (std::vector<std::size_t>{0, 0}));
    EXPECT_NEAR(across.lines.front().points.front().x(), 0.0, 1e-15);
    EXPECT_NEAR(across.lines.front().points.back().x(), 1.0, 1e-15);
    EXPECT_TRUE(isStrict(target.surface, across.lines.front()));

    // A ring that is beside the plate at two places has two parts; that at its start is one.
    const ProjectedLines ring =
        target.drape({{0.3, 0.3, 0}, {0.3, 1.4, 0}, {0.6, 1.4, 0}, {0.6, -0.3, 0}}, true);
    EXPECT_EQ(ring.gaps, (std::vector<std::size_t>{0, 2}));
    ASSERT_EQ(ring.lines.size(), 2U);
    for (const SurfacePolyline& line : ring.lines) {
        EXPECT_FALSE(line.closed);
        EXPECT_TRUE(isStrict(target.surface, line));
        for (const Vec3& end : {line.points.front(), line.points.back()}) {
            EXPECT_NEAR(std::abs(end.y() - 0.5), 0.5, 1e-15);
        }
    }
    EXPECT_EQ(
        projectionNote({{ring}}),
        "along the direction it is beside the mesh 2 times (first behind vertex 0), and parted "
        "there"
    );
    const ProjectedLines nothing = target.drape({{2, 2, 0}, {3, 2, 0}});
    EXPECT_TRUE(nothing.lines.empty());
    EXPECT_EQ(nothing.gaps, std::vector<std::size_t>{0});
}

TEST(DrapedPolyline, GoesDownWallsAndTellsOfThem) {
    const DrapeTarget steps(profile({{0, 0}, {0.25, 0}, {0.5, 0}, {0.5, 1}, {0.75, 1}, {1, 1}}, 4));
    const ProjectedLines draped = steps.drape({{0.1, 0.3, 5}, {0.9, 0.7, 5}});
    ASSERT_EQ(draped.lines.size(), 1U);
    EXPECT_EQ(draped.jumps, std::vector<std::size_t>{0});
    EXPECT_NEAR(lengthOf(draped.lines.front()), std::hypot(0.8, 0.4) + 1.0, 1e-5);
    EXPECT_TRUE(isStrict(steps.surface, draped.lines.front()));

    // Where the upper part overhangs the lower one the line goes round its rim.
    const DrapeTarget fold(profile({{0, 0}, {0.25, 0}, {0.6, 0}, {0.4, 1}, {0.75, 1}, {1, 1}}, 4));
    const ProjectedLines under = fold.drape({{0.1, 0.5, 5}, {0.9, 0.5, 5}});
    ASSERT_EQ(under.lines.size(), 1U);
    EXPECT_EQ(under.jumps, std::vector<std::size_t>{0});
    EXPECT_NEAR(lengthOf(under.lines.front()), 0.3 + 0.2 + std::hypot(0.2, 1.0) + 0.5, 1e-5);
}

TEST(DrapedPolyline, IsPartedWhereNoWayLeads) {
    TriangleMesh above =
        transformed(plate(4, 4), Eigen::Isometry3d(Eigen::Translation3d(0.5, 0, 1)), 1.0);
    const DrapeTarget plates(joined(plate(4, 4), above));
    const ProjectedLines draped = plates.drape({{0.1, 0.4, 5}, {1.4, 0.4, 5}});
    ASSERT_EQ(draped.lines.size(), 2U);
    EXPECT_EQ(draped.jumps, std::vector<std::size_t>{0});
    EXPECT_NEAR(draped.lines[0].points.back().x(), 0.5, 1e-5);
    EXPECT_NEAR(draped.lines[1].points.front().x(), 0.5, 1e-5);
}

TEST(DrapedPolyline, RefusesDistancesAndDirectionsThatAreWrong) {
    const DrapeTarget target(plate(4, 4));
    const std::vector<Vec3> line{{0.2, 0.2, 1}, {0.8, 0.7, 3}};
    expectRefused(
        [&] { return target.drape(line, false, kDown, 2.0); },
        InputErrorCode::PickTooFar,
        "away from the mesh along the direction"
    );
    EXPECT_EQ(target.drape(line, false, kDown, 3.5).lines.size(), 1U);
    expectRefused(
        [&] { return target.drape(line, false, Vec3::Zero()); },
        InputErrorCode::BadOption,
        "direction must be"
    );
}

TEST(DrapedPolyline, IsTheFirstFaceMetForRandomLinesAndDirections) {
    for (const TriangleMesh& mesh : {icosphere(2), torus(14, 9), box(3)}) {
        const DrapeTarget target(mesh);
        const double size = target.surface.diagonal();
        forEachSeed(caseCount(200, 8), [&](Random& random) {
            const auto any = [&] {
                return Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
            };
            const Vec3 direction = any().normalized();
            std::vector<Vec3> points{any(), any(), any(), any()};
            const ProjectedLines draped = target.drape(points, true, direction);
            for (const SurfacePolyline& line : draped.lines) {
                ASSERT_TRUE(isStrict(target.surface, line));
                if (!draped.jumps.empty()) {
                    continue;
                }
                for (const Vec3& point : line.points) {
                    double nearest = size;
                    for (std::size_t i = 0; i < points.size(); ++i) {
                        nearest = std::min(
                            nearest,
                            distanceBeside(point, points[i], points[(i + 1) % 4], direction)
                        );
                    }
                    // Exactly, but through vertices, at silhouettes and down small steps.
                    ASSERT_LT(nearest, 0.3 * target.surface.averageEdgeLength());
                }
            }
            // Every vertex of the polyline that is over the mesh is a vertex of the result.
            for (const Vec3& vertex : points) {
                const auto hit = target.tree.firstHit(vertex - 9.0 * direction, direction);
                const bool isThere =
                    std::ranges::any_of(draped.lines, [&](const SurfacePolyline& line) {
                        return std::ranges::any_of(line.points, [&](const Vec3& point) {
                            return (point - hit.position).norm() < 1e-12;
                        });
                    });
                ASSERT_TRUE(hit.point.face < 0 || isThere);
            }
        });
    }
}

TEST(ProjectedPolyline, TellsOfJumpsToAnotherPartOfTheMesh) {
    const DrapeTarget channel(
        profile({{0, 1}, {0, 0.5}, {0, 0}, {0.5, 0}, {1, 0}, {1, 0.5}, {1, 1}}, 4)
    );
    const auto project = [&](const std::vector<Vec3>& points) {
        return projectedLines(
            channel.surface, channel.tree, {.points = points, .closed = false}, {.distance = 1.0}
        );
    };
    const ProjectedLines across = project({{0.1, 0.5, 0.9}, {0.3, 0.5, 0.9}, {0.9, 0.5, 0.9}});
    EXPECT_EQ(across.jumps, std::vector<std::size_t>{1});
    EXPECT_EQ(
        projectionNote({{across}}),
        "it jumps 1 time (first behind vertex 1) from one part of the surface to another, and "
        "follows the surface there"
    );
    const ProjectedLines along = project({{0.1, 0.2, 0.9}, {0.1, 0.5, 0.2}, {0.9, 0.5, 0.1}});
    EXPECT_TRUE(along.jumps.empty());
    EXPECT_EQ(projectionNote({{along}}), "");
}

}  // namespace
}  // namespace bspline_curve
