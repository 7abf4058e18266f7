// SPDX-License-Identifier: GPL-3.0-or-later
// Distances of all vertices, against the plane and against shortest paths.
#include "offset/distances_to_lines.h"

#include "bspline_curve/error.h"
#include "bspline_curve/mesh.h"
#include "offset/distance_beams.h"
#include "support/meshes.h"
#include "support/random.h"
#include "surface/geodesic_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace bspline_curve {

namespace {

using namespace test_support;

constexpr double kEverywhere = std::numeric_limits<double>::infinity();

SurfacePolyline lineThrough(const Surface& surface, const std::vector<SurfacePoint>& points) {
    SurfacePolyline line;
    for (const SurfacePoint& point : points) {
        line.surfacePoints.push_back(point);
        line.points.push_back(surface.position(point));
    }
    return line;
}

}  // namespace

TEST(DistancesToLines, OfAPointInThePlaneAreStraight) {
    const Surface surface(plate(9, 7));
    const SurfacePoint at{.face = 31, .barycentric = {0.2, 0.5, 0.3}};
    const std::array lines{lineThrough(surface, {at})};
    const std::vector<double> distances = distancesToLines(surface, lines, kEverywhere);
    ASSERT_EQ(distances.size(), surface.vertices().size());
    for (int v = 0; v < surface.vertexCount(); ++v) {
        EXPECT_NEAR(distances[v], (surface.vertices()[v] - lines[0].points[0]).norm(), 1e-12);
    }
}

TEST(DistancesToLines, EndAtTheirReachAndAtGaps) {
    TriangleMesh mesh = plate(6, 6);
    const TriangleMesh other = plate(3, 3);
    const int first = static_cast<int>(mesh.vertices.size());
    for (const Vec3& vertex : other.vertices) {
        mesh.vertices.emplace_back(vertex + Vec3(5, 0, 0));
    }
    for (const Triangle& face : other.faces) {
        mesh.faces.push_back({face[0] + first, face[1] + first, face[2] + first});
    }
    const Surface surface(mesh);
    const std::array lines{lineThrough(surface, {{.face = 0, .barycentric = Vec3::UnitX()}})};
    const std::vector<double> all = distancesToLines(surface, lines, kEverywhere);
    const std::vector<double> near = distancesToLines(surface, lines, 0.4);
    for (int v = 0; v < surface.vertexCount(); ++v) {
        EXPECT_EQ(std::isfinite(all[v]), v < first);
        EXPECT_EQ(near[v], all[v] <= 0.4 ? all[v] : kEverywhere);
    }
}

// Two searches that share no code; every other vertex of such a mesh has more than a full turn.
TEST(DistancesToLines, AreTheLengthsOfShortestPathsOnRoughMeshes) {
    for (const TriangleMesh& mesh :
         {withNoise(icosphere(3), 0.05, 7), withNoise(plate(14, 14), 0.02, 8)}) {
        const Surface surface(mesh);
        const SurfacePoint start{.face = 17, .barycentric = {0.3, 0.3, 0.4}};
        const SurfacePoint second{.face = 90, .barycentric = {1, 0, 0}};
        const std::array lines{lineThrough(surface, {start}), lineThrough(surface, {second})};
        const std::vector<double> distances = distancesToLines(surface, lines, kEverywhere);
        GeodesicPathFinder finder(surface, {});
        for (int f = 0; f < surface.faceCount(); f += 11) {
            const SurfacePoint goal{.face = f, .barycentric = Vec3::UnitY()};
            const double shortest = std::min(
                finder.findShortest(start, goal)->length, finder.findShortest(second, goal)->length
            );
            EXPECT_NEAR(distances[surface.faces()[f][1]], shortest, 1e-9) << "face " << f;
        }
    }
}

TEST(DistancesToLines, HaveBoundsAroundAPoint) {
    const Surface surface(withNoise(icosphere(2), 0.05, 3));
    const std::array lines{lineThrough(
        surface,
        {{.face = 0, .barycentric = {0.2, 0.5, 0.3}}, {.face = 0, .barycentric = {0.5, 0.0, 0.5}}}
    )};
    const DistanceBeams beams(surface, lines, {.from = 0.0, .to = 10.0});
    Random random(7);
    double tightest = 1.0;
    for (int i = 0; i < 3000; ++i) {
        const int face = random.integer(0, surface.faceCount() - 1);
        const auto inside = [&] {
            const double u = random.uniform(0.0, 1.0);
            const double v = random.uniform(0.0, 1.0 - u);
            return SurfacePoint{.face = face, .barycentric = {u, v, 1.0 - u - v}};
        };
        const SurfacePoint centre = inside();
        const SurfacePoint other = inside();
        const double way = (surface.position(other) - surface.position(centre)).norm();
        const double least = beams.leastNear(centre, way);
        EXPECT_LE(least, beams.at(other).distance + 1e-9) << i;
        tightest = std::min(tightest, beams.at(centre).distance - way - least);
    }
    EXPECT_NEAR(tightest, 0.0, 1e-6);
}

TEST(DistancesToLines, RefuseALineThatLeavesItsFaces) {
    const Surface surface(plate(6, 6));
    const SurfacePoint a{.face = 0, .barycentric = Vec3::Constant(1.0 / 3.0)};
    const SurfacePoint b{.face = 50, .barycentric = Vec3::Constant(1.0 / 3.0)};
    const std::array lines{lineThrough(surface, {a, b})};
    EXPECT_THROW((void)distancesToLines(surface, lines, kEverywhere), InputError);
}

}  // namespace bspline_curve
