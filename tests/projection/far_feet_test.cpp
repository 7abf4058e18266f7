// SPDX-License-Identifier: GPL-3.0-or-later
// Feet of points far from the surface, beside creases, beyond boundaries, and over any directions.
#include "projection/feet.h"
#include "shell/built_shell.h"
#include "support/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

namespace bspline_curve {
namespace {

using namespace test_support;

// ---- Far from the surface ----

TEST(FeetOfFarPoints, AreFoundAlongFibresWhereTheseSpread) {
    const ExtendedSurface extended = baseOf(withNoise(icosphere(3), 0.01, 7));
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        FootPoint from = randomFoot(extended, random, 0.0);
        from.height = random.uniform(0.1, 3.0);
        const Vec3 p = pointOver(extended, from);
        const Found found = find(extended, p, centreOf(from.face));
        EXPECT_TRUE(expectFootOrNearest(extended, p, found));
        EXPECT_NEAR(found.foot.height, from.height, 0.02 * from.height);
    }
}

TEST(FeetOfFarPoints, AreNearestPointsWhereFibresMeet) {
    const ExtendedSurface extended = baseOf(icosphere(3));
    const double radius = 1.0 / extended.frame.scale;
    for (const double share : {0.0, 0.02}) {
        int nearest = 0;
        for (int face = 0; face < faceCountOf(extended); face += 37) {
            const Vec3 p = share * radius * footPosition(extended, centreOf(face)).normalized();
            const Found found = find(extended, p, centreOf(face));
            nearest += expectFootOrNearest(extended, p, found) ? 0 : 1;
            EXPECT_NEAR(found.foot.height, -(1.0 - share) * radius, 0.01 * radius);
        }
        EXPECT_GT(nearest, 10);
    }
}

// ---- Creases ----

// A plate bent along the line x = 0, upwards: fibres cross above it.
TriangleMesh groove(int cells, double slope) {
    TriangleMesh mesh = plate(2 * cells, cells, 2.0, 1.0);
    for (Vec3& p : mesh.vertices) {
        p.x() -= 1.0;
        p.z() = slope * std::abs(p.x());
    }
    return mesh;
}

TEST(FeetInAGroove, AreNearestPointsWhereFibresCross) {
    const ExtendedSurface extended = baseOf(groove(10, 1.0));
    int nearest = 0;
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const Vec3 p = extended.frame.toUnit(
            {random.uniform(-0.5, 0.5), random.uniform(0.1, 0.9), random.uniform(0.6, 1.4)}
        );
        const int start = random.integer(0, extended.surfaceFaceCount - 1);
        const Found found = find(extended, p, centreOf(start));
        if (expectFootOrNearest(extended, p, found)) {
            continue;
        }
        ++nearest;
        EXPECT_GT(found.foot.height, 0.0);
        // Either side of the groove has a nearest point of its own.
        EXPECT_GE(found.foot.height, distanceToSurface(extended, p) - 1e-12);
        // The height is the distance, so its gradient has unit length and points to p.
        const Vec3 gap = p - footPosition(extended, found.foot);
        EXPECT_LT((found.frame.height - gap.normalized()).norm(), 1e-9);
    }
    EXPECT_GT(nearest, 20);
}

TEST(FeetInAGroove, HaveTheSideOfTheirPoints) {
    // Deep under a ridge the fibres of both sides cross: the same mesh from below.
    TriangleMesh ridge = groove(10, 1.0);
    for (Vec3& p : ridge.vertices) {
        p.z() = -p.z();
    }
    const ExtendedSurface extended = baseOf(ridge);
    int nearest = 0;
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const Vec3 p = extended.frame.toUnit(
            {random.uniform(-0.4, 0.4), random.uniform(0.1, 0.9), random.uniform(-1.4, -0.6)}
        );
        const Found found =
            find(extended, p, centreOf(random.integer(0, extended.surfaceFaceCount - 1)));
        nearest += expectFootOrNearest(extended, p, found) ? 0 : 1;
        EXPECT_LT(found.foot.height, 0.0);
    }
    EXPECT_GT(nearest, 3);
}

// ---- Boundaries ----

// Farther beyond the boundary of a unit plate than its ghosts.
Vec3 pointBesideAPlate(const ExtendedSurface& extended, std::uint64_t seed) {
    Random random(seed);
    Vec3 user{random.uniform(-0.5, 1.5), random.uniform(1.1, 1.5), random.uniform(-0.1, 0.1)};
    if (seed % 2 == 0) {
        std::swap(user.x(), user.y());
    }
    return extended.frame.toUnit(user);
}

TEST(FeetBeyondABoundary, LieInGhostFaces) {
    const ExtendedSurface extended = baseOf(jitteredPlate(12, 12, 0.2, 3));
    const double edge = meanEdge(extended);
    for (int face = extended.surfaceFaceCount; face < faceCountOf(extended); ++face) {
        FootPoint from = centreOf(face);
        from.height = 0.1 * edge;
        const Vec3 p = pointOver(extended, from);
        const int inside = *std::ranges::max_element(extended.faceNeighbours[face]);
        const int start = *std::ranges::min_element(
            extended.faceNeighbours[face], {}, [&](int next) { return next < 0 ? inside : next; }
        );
        const Found found = find(extended, p, centreOf(start));
        EXPECT_TRUE(expectFootOrNearest(extended, p, found));
        EXPECT_GE(found.foot.face, extended.surfaceFaceCount);
        EXPECT_NEAR(found.foot.height, from.height, 1e-9);
    }
}

TEST(FeetBeyondABoundary, AreOnTheOuterRimWhereGhostsEnd) {
    const ExtendedSurface extended = baseOf(jitteredPlate(12, 12, 0.2, 3));
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const Vec3 p = pointBesideAPlate(extended, seed);
        Random random(seed);
        const Found found =
            find(extended, p, centreOf(random.integer(0, extended.surfaceFaceCount - 1)));
        expectFinite(found);
        EXPECT_GE(found.foot.face, extended.surfaceFaceCount);
        EXPECT_NEAR(found.foot.barycentric().minCoeff(), 0.0, 1e-12);
        EXPECT_NEAR(
            std::abs(found.foot.height), (footPosition(extended, found.foot) - p).norm(), 1e-12
        );
        EXPECT_GE(std::abs(found.foot.height), distanceToSurface(extended, p) - 1e-12);
        EXPECT_EQ(found.foot.height < 0.0, p.z() < 0.0);
    }
}

TEST(FeetBeyondABoundary, AreNearestOfAllFacesAroundARimsVertex) {
    const ExtendedSurface extended = baseOf(jitteredPlate(12, 12, 0.2, 3));
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const Vec3 p = pointBesideAPlate(extended, seed);
        Random random(seed);
        const Found found =
            find(extended, p, centreOf(random.integer(0, extended.surfaceFaceCount - 1)));
        EXPECT_FALSE(expectFootOrNearest(extended, p, found));
    }
}

// ---- Any point, any directions ----

TEST(FeetOfAnyPoint, AreFiniteAndHereOrNearestWhateverTheDirections) {
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        ExtendedSurface extended =
            baseOf(seed % 3 == 0 ? tennisBallVertex() : withNoise(icosphere(1), 0.2, seed));
        if (seed % 3 == 1) {
            // Directions that see their faces from behind, from the side, or not at all.
            for (Vec3& direction : extended.directions) {
                direction = random.point(-1.0, 1.0).normalized();
            }
        } else if (seed % 3 == 2) {
            extended.directions[random.integer(0, 10)] = Vec3::Zero();
        }
        for (int i = 0; i < 30; ++i) {
            const int face = random.integer(0, faceCountOf(extended) - 1);
            const Vec3 barycentric = random.awkwardBarycentric();
            const Vec3 p =
                i % 3 == 0 ? random.point(-1.0, 1.0) : extended.position({face, barycentric});
            const int start = random.integer(0, faceCountOf(extended) - 1);
            const Found found = find(extended, p, centreOf(start));
            expectFinite(found);
            EXPECT_GE(found.foot.barycentric().minCoeff(), -1e-3);
        }
    }
}

TEST(FeetOfAnyPoint, AreOnTheSurfaceForPointsOfIt) {
    const ExtendedSurface extended = baseOf(withNoise(icosphere(2), 0.02, 3));
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const int face = random.integer(0, faceCountOf(extended) - 1);
        const Vec3 p = extended.position({face, random.awkwardBarycentric()});
        const Found found = find(extended, p, centreOf(face));
        EXPECT_TRUE(expectFootOrNearest(extended, p, found));
        EXPECT_NEAR(found.foot.height, 0.0, 1e-9);
    }
}

}  // namespace
}  // namespace bspline_curve
