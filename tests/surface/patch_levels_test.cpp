// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/patch_levels.h"

#include "support/meshes.h"
#include "support/random.h"
#include "surface/geodesic_path.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

constexpr double kFar = std::numeric_limits<double>::infinity();

Vec3 centreOf(const Surface& surface, int face) {
    return surface.position({face, Vec3::Constant(1.0 / 3.0)});
}

// The face whose centre is nearest to a point, with its centre.
SurfacePoint nearest(const Surface& surface, const Vec3& point) {
    int best = 0;
    for (int f = 1; f < surface.faceCount(); ++f) {
        if ((centreOf(surface, f) - point).norm() < (centreOf(surface, best) - point).norm()) {
            best = f;
        }
    }
    return {best, Vec3::Constant(1.0 / 3.0)};
}

// The patches of one level that are joined by edges between faces.
std::set<std::pair<int, int>> joinedPatches(const Surface& surface, const std::vector<int>& patch) {
    std::set<std::pair<int, int>> pairs;
    for (int f = 0; f < surface.faceCount(); ++f) {
        for (const int g : surface.faceNeighbours()[f]) {
            if (g >= 0 && patch[f] != patch[g]) {
                pairs.emplace(patch[f], patch[g]);
            }
        }
    }
    return pairs;
}

// How many pieces the faces of all patches fall into.
int pieces(const Surface& surface, const std::vector<int>& patch) {
    std::vector<char> seen(patch.size(), 0);
    int count = 0;
    for (int f = 0; f < surface.faceCount(); ++f) {
        std::vector<int> stack;
        if (seen[f] == 0) {
            ++count;
            seen[f] = 1;
            stack.push_back(f);
        }
        while (!stack.empty()) {
            const int here = stack.back();
            stack.pop_back();
            for (const int g : surface.faceNeighbours()[here]) {
                if (g >= 0 && seen[g] == 0 && patch[g] == patch[here]) {
                    seen[g] = 1;
                    stack.push_back(g);
                }
            }
        }
    }
    return count;
}

void expectGoodLevels(const Surface& surface) {
    const PatchLevels patches(surface);
    ASSERT_FALSE(patches.levels().empty());
    std::vector<int> patch(surface.faceCount());
    for (int f = 0; f < surface.faceCount(); ++f) {
        patch[f] = f;
    }
    int below = surface.faceCount();
    for (const PatchLevels::Level& level : patches.levels()) {
        SCOPED_TRACE("level of " + std::to_string(level.count()) + " patches");
        EXPECT_LT(level.count(), below / 3);
        below = level.count();
        for (int& p : patch) {
            p = level.patchOf[p];
        }
        EXPECT_EQ(pieces(surface, patch), level.count());
        std::set<std::pair<int, int>> listed;
        for (int p = 0; p < level.count(); ++p) {
            for (int i = level.offsets[p]; i < level.offsets[p + 1]; ++i) {
                EXPECT_TRUE(listed.emplace(p, level.neighbours[i]).second);
            }
        }
        EXPECT_EQ(listed, joinedPatches(surface, patch));
        for (int p = 0; p < level.count(); ++p) {
            EXPECT_EQ(patch[level.samples[p][0]], p);
            for (const int f : level.samples[p]) {
                EXPECT_TRUE(f < 0 || patch[f] == p);
            }
        }
    }
}

TEST(PatchLevels, HoldConnectedPatchesOfAllFaces) {
    expectGoodLevels(Surface(icosphere(6)));
    expectGoodLevels(Surface(jitteredPlate(90, 90, 0.29, 1)));
    expectGoodLevels(Surface(openCylinder(24, 400, 1.0, 3.0)));
}

TEST(PatchLevels, AreNoneOnSmallSurfaces) {
    EXPECT_TRUE(PatchLevels(Surface(icosphere(3))).levels().empty());
}

std::optional<GeodesicPath> pathOn(
    const Surface& surface,
    const PatchLevels& patches,
    const Vec3& from,
    const Vec3& to,
    TravelCosts costs = {}
) {
    GeodesicPathFinder finder(surface, std::move(costs), &patches);
    return finder.find(nearest(surface, from), nearest(surface, to));
}

TEST(PathsAlongPatches, AreAsLongAsThoseOfASearchOfAllFaces) {
    const Surface surface(withNoise(icosphere(5), 0.003, 4));
    const PatchLevels patches(surface);
    GeodesicPathFinder along(surface, {}, &patches);
    GeodesicPathFinder everywhere(surface, {});
    for (int i = 0; i < 60; ++i) {
        SCOPED_TRACE("pair " + std::to_string(i));
        const SurfacePoint a{(i * 7919) % surface.faceCount(), Vec3::Constant(1.0 / 3.0)};
        const SurfacePoint b{(i * 104729 + 5000) % surface.faceCount(), {0.2, 0.3, 0.5}};
        const std::optional<GeodesicPath> path = along.find(a, b);
        ASSERT_TRUE(path.has_value());
        const double length = everywhere.find(a, b)->length;
        EXPECT_LT(path->length, 1.01 * length);
        EXPECT_GT(path->length, 0.98 * length);
    }
}

// A field with valleys across the sphere.
TravelCosts valleys(const Surface& surface) {
    return {[&surface](int f) {
        const Vec3 p = centreOf(surface, f);
        return 1.0 + 4.0 * std::abs(std::sin(9.0 * p.x()) + std::sin(7.0 * p.y() * p.z()));
    }};
}

struct Work {
    double length = 0.0;
    std::size_t explored = 0;
};

Work workOn(const Surface& surface, TravelCosts costs) {
    const PatchLevels patches(surface);
    GeodesicPathFinder finder(surface, std::move(costs), &patches);
    Work work;
    for (int i = 0; i < 12; ++i) {
        const double a = 0.5 * i;
        const Vec3 from(std::cos(a), std::sin(a), 0.1);
        const Vec3 to(std::cos(a + 1.3), std::sin(a + 1.3), std::sin(a));
        const std::optional<GeodesicPath> path =
            finder.find(nearest(surface, from), nearest(surface, to));
        EXPECT_TRUE(path.has_value());
        work.length += path ? path->length : 0.0;
    }
    work.explored = finder.explored();
    return work;
}

// Twice as many are on the way itself. Each step may add a level of patches, so the mean of two
// steps counts.
TEST(PathsAlongPatches, LookAtTwiceAsMuchOfASurfaceWithFourTimesTheFaces) {
    const TriangleMesh mesh = withNoise(icosphere(4), 0.003, 5);
    const Surface coarse(mesh);
    const Surface fine(midpointSubdivide(midpointSubdivide(mesh)));
    constexpr double kMostPerStep = 2.3;
    const Work plain = workOn(coarse, {});
    const Work plainFine = workOn(fine, {});
    EXPECT_LT(
        std::sqrt(static_cast<double>(plainFine.explored) / static_cast<double>(plain.explored)),
        kMostPerStep
    );
    EXPECT_NEAR(plainFine.length, plain.length, 0.01 * plain.length);
    const Work costly = workOn(coarse, valleys(coarse));
    const Work costlyFine = workOn(fine, valleys(fine));
    EXPECT_LT(
        std::sqrt(static_cast<double>(costlyFine.explored) / static_cast<double>(costly.explored)),
        kMostPerStep
    );
}

// ---- Jumps ----

// Up to half of the sphere away.
TEST(JumpsAlongPatches, LeadNearWhereTheyAreToLead) {
    const Surface surface(icosphere(6));
    const PatchLevels patches(surface);
    const double edge = surface.averageEdgeLength();
    Random random(3);
    for (int trial = 0; trial < 200; ++trial) {
        const int from = random.integer(0, surface.faceCount() - 1);
        const int to = random.integer(0, surface.faceCount() - 1);
        const Vec3 goal = centreOf(surface, to);
        const double away = (centreOf(surface, from) - goal).norm();
        if (away < 12.0 * edge || away > 1.4) {
            continue;
        }
        const PatchLevels::Samples* const samples = patches.samplesTowards(goal, from, away / edge);
        ASSERT_NE(samples, nullptr);
        for (const int face : *samples) {
            if (face >= 0) {
                EXPECT_LT((centreOf(surface, face) - goal).norm(), 0.7 * away);
            }
        }
    }
}

TEST(JumpsAlongPatches, AreNotMadeWherePatchesAreTooLarge) {
    const Surface surface(icosphere(6));
    const PatchLevels patches(surface);
    EXPECT_EQ(patches.samplesTowards({0.0, 0.0, -1.0}, 0, 2.0), nullptr);
    EXPECT_EQ(patches.samplesTowards(centreOf(surface, 0), 0, 100.0), nullptr);
    const Surface small(icosphere(3));
    EXPECT_EQ(PatchLevels(small).samplesTowards({0.0, 0.0, -1.0}, 0, 100.0), nullptr);
}

TEST(JumpsAlongPatches, StayOnTheirComponent) {
    const Eigen::Isometry3d aside(Eigen::Translation3d(2.001, 0.0, 0.0));
    const Surface spheres(joined(icosphere(5), transformed(icosphere(5), aside)));
    const PatchLevels patches(spheres);
    const int from = nearest(spheres, Vec3::UnitZ()).face;
    const PatchLevels::Samples* const samples = patches.samplesTowards({1.5, 0.0, 0.5}, from, 40.0);
    ASSERT_NE(samples, nullptr);
    for (const int face : *samples) {
        EXPECT_TRUE(face < 0 || spheres.faceComponents()[face] == spheres.faceComponents()[from]);
    }
}

// The plate's upper side is as near as can be to the lower one.
TEST(PathsAlongPatches, GoRoundTheEdgeOfAThinPlate) {
    const Surface surface(box(40, {1.0, 1.0, 1e-3}));
    const PatchLevels patches(surface);
    ASSERT_FALSE(patches.levels().empty());
    const std::optional<GeodesicPath> path =
        pathOn(surface, patches, {0.3, 0.5, 1e-3}, {0.31, 0.52, 0.0});
    ASSERT_TRUE(path.has_value());
    EXPECT_NEAR(path->length, 0.61, 0.03);
}

// Walls of one row of faces, each with a gap at another end.
TEST(PathsAlongPatches, FindTheWayThroughALabyrinth) {
    constexpr int kRows = 81;
    const Surface surface(plate(kRows, kRows));
    const auto isWall = [&](int f) {
        const Vec3 centre = centreOf(surface, f);
        const int row = static_cast<int>(centre.y() * kRows);
        const bool isGap = row % 8 == 3 ? centre.x() > 1.0 - 1.0 / kRows : centre.x() < 1.0 / kRows;
        return row % 4 == 3 && !isGap;
    };
    const PatchLevels patches(surface);
    ASSERT_FALSE(patches.levels().empty());
    const TravelCosts costs{[&](int f) { return isWall(f) ? kFar : 1.0; }};
    const std::optional<GeodesicPath> path =
        pathOn(surface, patches, {0.01, 0.01, 0.0}, {0.5, 0.99, 0.0}, costs);
    ASSERT_TRUE(path.has_value());
    EXPECT_GT(path->length, 18.0);
    for (const SurfacePoint& point : path->points) {
        EXPECT_FALSE(isWall(point.face));
    }
}

TEST(PathsAlongPatches, DoNotExistBetweenComponentsOrThroughClosedWalls) {
    const Eigen::Isometry3d aside(Eigen::Translation3d(2.001, 0.0, 0.0));
    const Surface spheres(joined(icosphere(4), transformed(icosphere(4), aside)));
    const PatchLevels patches(spheres);
    ASSERT_FALSE(patches.levels().empty());
    EXPECT_FALSE(pathOn(spheres, patches, Vec3::UnitX(), {1.001, 0.0, 0.0}).has_value());
    const TravelCosts halves{[&](int f) {
        return std::abs(centreOf(spheres, f).z()) < 0.1 ? kFar : 1.0;
    }};
    EXPECT_FALSE(pathOn(spheres, patches, Vec3::UnitZ(), -Vec3::UnitZ(), halves).has_value());
    EXPECT_TRUE(pathOn(spheres, patches, Vec3::UnitZ(), {0.8, 0.0, 0.6}, halves).has_value());
}

}  // namespace
}  // namespace bspline_curve
