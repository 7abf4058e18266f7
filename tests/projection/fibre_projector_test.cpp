// SPDX-License-Identifier: GPL-3.0-or-later
// Feet of points over surfaces: P = q + height n(q), wherever the fibres allow it, and the nearest
// point nearby elsewhere.
#include "projection/fibre_projector.h"

#include "shell/built_shell.h"
#include "support/meshes.h"
#include "support/random.h"
#include "surface/closest_point.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

int faceCountOf(const ExtendedSurface& extended) {
    return static_cast<int>(extended.faces.size());
}

ExtendedSurface baseOf(const TriangleMesh& mesh) {
    return extendSurface(Surface(mesh), 3);
}

double meanEdge(const ExtendedSurface& extended) {
    double sum = 0.0;
    int count = 0;
    for (const double length : extended.edgeLengths) {
        sum += length;
        count += length > 0.0 ? 1 : 0;
    }
    return sum / count;
}

Vec3 combine(const std::vector<Vec3>& values, const Triangle& face, const Vec3& weights) {
    return weights[0] * values[face[0]] + weights[1] * values[face[1]] +
           weights[2] * values[face[2]];
}

Vec3 directionAt(const ExtendedSurface& extended, const FootPoint& foot) {
    return combine(extended.directions, extended.faces[foot.face], foot.barycentric());
}

Vec3 footPosition(const ExtendedSurface& extended, const FootPoint& foot) {
    return extended.position({foot.face, foot.barycentric()});
}

Vec3 pointOver(const ExtendedSurface& extended, const FootPoint& foot) {
    return footPosition(extended, foot) + foot.height * directionAt(extended, foot);
}

FootPoint centreOf(int face) {
    return {face, 1.0 / 3.0, 1.0 / 3.0, 0.0};
}

FootPoint randomFoot(const ExtendedSurface& extended, Random& random, double highest) {
    const int face = random.integer(0, faceCountOf(extended) - 1);
    const Vec3 barycentric = random.barycentric();
    return {face, barycentric[1], barycentric[2], random.uniform(-highest, highest)};
}

struct Found {
    FootPoint foot;
    FootFrame frame;
};

Found find(const ExtendedSurface& extended, const Vec3& p, const FootPoint& start) {
    Found found{start, {}};
    FibreProjector(extended).move(p, found.foot, found.frame);
    return found;
}

// ---- Brute force over all faces ----

// The foot of p in one face, where its fibres lead there; Newton's method on the 3 x 3 system, with
// the matrix inverted as a whole.
std::optional<FootPoint> footIn(const ExtendedSurface& extended, int face, const Vec3& p) {
    const Triangle& corners = extended.faces[face];
    const auto difference = [&](const std::vector<Vec3>& values, std::size_t corner) {
        return Vec3(values[corners[corner]] - values[corners[0]]);
    };
    FootPoint foot = centreOf(face);
    for (int step = 0; step < 30; ++step) {
        Eigen::Matrix3d jacobian;
        jacobian.col(0) =
            difference(extended.vertices, 1) + foot.height * difference(extended.directions, 1);
        jacobian.col(1) =
            difference(extended.vertices, 2) + foot.height * difference(extended.directions, 2);
        jacobian.col(2) = directionAt(extended, foot);
        const Vec3 change = jacobian.fullPivLu().solve(p - pointOver(extended, foot));
        foot.u += change[0];
        foot.v += change[1];
        foot.height += change[2];
    }
    const bool isSolved = (pointOver(extended, foot) - p).norm() < 1e-12;
    return isSolved && foot.barycentric().minCoeff() >= -1e-9 ? std::optional(foot) : std::nullopt;
}

// All feet of p with heights up to a bound.
std::vector<FootPoint> allFeet(const ExtendedSurface& extended, const Vec3& p, double highest) {
    std::vector<FootPoint> feet;
    for (int face = 0; face < faceCountOf(extended); ++face) {
        const std::optional<FootPoint> foot = footIn(extended, face, p);
        if (foot && std::abs(foot->height) <= highest) {
            feet.push_back(*foot);
        }
    }
    return feet;
}

double distanceToSurface(const ExtendedSurface& extended, const Vec3& p) {
    double least = std::numeric_limits<double>::infinity();
    for (const Triangle& face : extended.faces) {
        least = std::min(least, closestPointOnTriangle(extended.vertices, face, p).squaredDistance);
    }
    return std::sqrt(least);
}

Vec3 normalOf(const ExtendedSurface& extended, int face) {
    const Triangle& corners = extended.faces[face];
    const Vec3& a = extended.vertices[corners[0]];
    return (extended.vertices[corners[1]] - a)
        .cross(extended.vertices[corners[2]] - a)
        .normalized();
}

// Distance to the faces that hold a foot: one, two on an edge, all around a vertex.
double distanceNearby(const ExtendedSurface& extended, const Vec3& p, const FootPoint& foot) {
    const Triangle& here = extended.faces[foot.face];
    const Vec3 barycentric = foot.barycentric();
    double least = std::numeric_limits<double>::infinity();
    for (const Triangle& other : extended.faces) {
        bool holds = true;
        for (int k = 0; k < 3; ++k) {
            holds &= barycentric[k] < 1e-12 || std::ranges::find(other, here[k]) != other.end();
        }
        if (holds) {
            least = std::min(
                least, closestPointOnTriangle(extended.vertices, other, p).squaredDistance
            );
        }
    }
    return std::sqrt(least);
}

void expectFinite(const Found& found) {
    EXPECT_TRUE(std::isfinite(found.foot.u) && std::isfinite(found.foot.v));
    EXPECT_TRUE(std::isfinite(found.foot.height));
    for (const Vec3& v :
         {found.frame.direction,
          found.frame.height,
          found.frame.u,
          found.frame.v,
          found.frame.turnU,
          found.frame.turnV}) {
        EXPECT_TRUE(v.allFinite());
    }
}

// Expects that a foot lies under p by its fibre, or else is the nearest point of the faces that
// hold it. Returns whether the first is so.
bool expectFootOrNearest(const ExtendedSurface& extended, const Vec3& p, const Found& found) {
    expectFinite(found);
    EXPECT_LT(found.foot.face, static_cast<int>(extended.faces.size()));
    EXPECT_GE(found.foot.barycentric().minCoeff(), -1e-3);
    EXPECT_NEAR(found.frame.direction.norm(), 1.0, 1e-12);
    if ((pointOver(extended, found.foot) - p).norm() < 1e-9) {
        return true;
    }
    const double distance = (footPosition(extended, found.foot) - p).norm();
    EXPECT_NEAR(std::abs(found.foot.height), distance, 1e-12);
    EXPECT_NEAR(distance, distanceNearby(extended, p, found.foot), 1e-12);
    return false;
}

// ---- Surfaces where fibres are of use all around ----

struct Shape {
    std::string name;
    TriangleMesh mesh;
};

std::ostream& operator<<(std::ostream& stream, const Shape& shape) {
    return stream << shape.name;
}

class FeetNear : public testing::TestWithParam<Shape> {
protected:
    ExtendedSurface extended_ = baseOf(GetParam().mesh);
    double edge_ = meanEdge(extended_);
};

TEST_P(FeetNear, AreThoseThatPointsWereRaisedFrom) {
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const FootPoint from = randomFoot(extended_, random, 0.2 * edge_);
        const Vec3 p = pointOver(extended_, from);
        // From its own face, and from those beside it, but not round an edge of a box.
        std::vector<int> starts = {from.face};
        for (const int next : extended_.faceNeighbours[from.face]) {
            if (next >= 0 && normalOf(extended_, from.face).dot(normalOf(extended_, next)) > 0.5) {
                starts.push_back(next);
            }
        }
        for (const int start : starts) {
            const Found found = find(extended_, p, centreOf(start));
            EXPECT_TRUE(expectFootOrNearest(extended_, p, found));
            EXPECT_NEAR(found.foot.height, from.height, 1e-3 * edge_);
            if (found.foot.face == from.face) {
                EXPECT_NEAR(found.foot.u, from.u, 1e-9);
                EXPECT_NEAR(found.foot.v, from.v, 1e-9);
                EXPECT_NEAR(found.foot.height, from.height, 1e-9 * edge_);
            } else {
                EXPECT_LT(from.barycentric().minCoeff(), 1e-2);
            }
        }
    }
}

TEST_P(FeetNear, HaveTheFramesOfTheirDifferences) {
    int tried = 0;
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const FootPoint from = randomFoot(extended_, random, 0.2 * edge_);
        if (from.barycentric().minCoeff() < 0.02) {
            continue;
        }
        ++tried;
        const Vec3 p = pointOver(extended_, from);
        const Found here = find(extended_, p, from);
        const double h = 1e-4 * edge_;
        for (int axis = 0; axis < 3; ++axis) {
            const FootPoint up = find(extended_, p + h * Vec3::Unit(axis), from).foot;
            const FootPoint down = find(extended_, p - h * Vec3::Unit(axis), from).foot;
            ASSERT_EQ(up.face, from.face);
            ASSERT_EQ(down.face, from.face);
            const double scale = 1e-5 / edge_;
            EXPECT_NEAR((up.height - down.height) / (2.0 * h), here.frame.height[axis], 1e-5);
            EXPECT_NEAR((up.u - down.u) / (2.0 * h), here.frame.u[axis], scale);
            EXPECT_NEAR((up.v - down.v) / (2.0 * h), here.frame.v[axis], scale);
        }
        const Vec3 n = directionAt(extended_, from);
        EXPECT_LT((here.frame.direction - n.normalized()).norm(), 1e-9);
        FootPoint beside = from;
        beside.u += 0.01;
        EXPECT_LT((here.frame.turnU - (directionAt(extended_, beside) - n) / 0.01).norm(), 1e-9);
        beside = from;
        beside.v += 0.01;
        EXPECT_LT((here.frame.turnV - (directionAt(extended_, beside) - n) / 0.01).norm(), 1e-9);
    }
    EXPECT_GT(tried, 50);
}

TEST_P(FeetNear, ArePredictedToSecondOrder) {
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const FootPoint from = randomFoot(extended_, random, 0.2 * edge_);
        if (from.barycentric().minCoeff() < 0.02) {
            continue;
        }
        const Vec3 p = pointOver(extended_, from);
        const Found here = find(extended_, p, from);
        const Vec3 way = random.point(-1.0, 1.0).normalized() * edge_;
        const auto errorAfter = [&](double share) {
            FootPoint foot = here.foot;
            FibreProjector::predict(share * way, here.frame, foot);
            return (pointOver(extended_, foot) - (p + share * way)).norm() / edge_;
        };
        EXPECT_LT(errorAfter(1e-2), 1e-3);
        EXPECT_LT(errorAfter(1e-4), 1e-7);
    }
}

TEST_P(FeetNear, AreAmongThoseOfASearchOverAllFaces) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const FootPoint from = randomFoot(extended_, random, 0.2 * edge_);
        const Vec3 p = pointOver(extended_, from);
        const Found found = find(extended_, p, from);
        const std::vector<FootPoint> feet = allFeet(extended_, p, 0.3 * edge_);
        ASSERT_FALSE(feet.empty());
        EXPECT_TRUE(std::ranges::any_of(feet, [&](const FootPoint& foot) {
            return (footPosition(extended_, foot) - footPosition(extended_, found.foot)).norm() <
                       1e-6 * edge_ &&
                   std::abs(foot.height - found.foot.height) < 1e-6 * edge_;
        }));
    }
}

TEST_P(FeetNear, AreTheSameAfterAWalkOverManyFaces) {
    int far = 0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const FootPoint from = randomFoot(extended_, random, 0.1 * edge_);
        const FootPoint start = randomFoot(extended_, random, 0.1 * edge_);
        const double away = (footPosition(extended_, from) - footPosition(extended_, start)).norm();
        // No farther than that the surface goes on without turning away.
        if (away > 8.0 * edge_ ||
            normalOf(extended_, from.face).dot(normalOf(extended_, start.face)) < 0.8) {
            continue;
        }
        far += away > 3.0 * edge_ ? 1 : 0;
        const Vec3 p = pointOver(extended_, from);
        const Found found = find(extended_, p, start);
        EXPECT_TRUE(expectFootOrNearest(extended_, p, found));
        EXPECT_LT(
            (footPosition(extended_, found.foot) - footPosition(extended_, from)).norm(),
            1e-2 * edge_
        );
        EXPECT_NEAR(found.foot.height, from.height, 1e-2 * edge_);
    }
    EXPECT_GT(far, 3);
}

INSTANTIATE_TEST_SUITE_P(
    All,
    FeetNear,
    testing::Values(
        Shape{"Sphere", icosphere(3)},
        Shape{"NoisySphere", withNoise(icosphere(3), 0.01, 7)},
        Shape{"Torus", torus(36, 16)},
        Shape{"Plate", jitteredPlate(12, 12, 0.25, 5)},
        Shape{"Box", box(6, {1.0, 0.8, 0.6})}
    ),
    [](const auto& testInfo) { return testInfo.param.name; }
);

// ---- By way of patches ----

TEST(FeetFoundByPatches, AreThoseFoundFaceByFace) {
    const Surface surface(withNoise(icosphere(6), 0.0005, 7));
    const ExtendedSurface extended = extendSurface(surface, 3);
    const PatchLevels patches(surface);
    ASSERT_FALSE(patches.levels().empty());
    const double edge = meanEdge(extended);
    const FibreProjector jumping(extended, &patches);
    const FibreProjector walking(extended);
    int far = 0;
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const FootPoint goal = randomFoot(extended, random, 0.5 * edge);
        const FootPoint start = randomFoot(extended, random, 0.0);
        if (normalOf(extended, goal.face).dot(normalOf(extended, start.face)) < 0.5) {
            continue;
        }
        far += (footPosition(extended, goal) - footPosition(extended, start)).norm() > 20.0 * edge
                   ? 1
                   : 0;
        const Vec3 p = pointOver(extended, goal);
        Found jumped{start, {}};
        Found walked{start, {}};
        jumping.move(p, jumped.foot, jumped.frame);
        walking.move(p, walked.foot, walked.frame);
        EXPECT_TRUE(expectFootOrNearest(extended, p, jumped));
        EXPECT_LT(
            (footPosition(extended, jumped.foot) - footPosition(extended, walked.foot)).norm(),
            1e-2 * edge
        );
        EXPECT_NEAR(jumped.foot.height, walked.foot.height, 1e-2 * edge);
    }
    EXPECT_GT(far, 20);
}

// Patches at its rim reach round it, so that their nearest face may lie on the other side.
TEST(FeetFoundByPatches, StayOnTheirSideOfAThinDisc) {
    TriangleMesh disc = icosphere(6);
    for (Vec3& vertex : disc.vertices) {
        vertex.z() *= 0.003;
    }
    const Surface surface(disc);
    const ExtendedSurface extended = extendSurface(surface, 3);
    const PatchLevels patches(surface);
    ASSERT_FALSE(patches.levels().empty());
    const FibreProjector finder(extended, &patches);
    std::vector<int> upper;
    for (int face = 0; face < faceCountOf(extended); ++face) {
        if (normalOf(extended, face).z() > 0.9) {
            upper.push_back(face);
        }
    }
    // In the middle of the disc, which is the frame's centre.
    const int start = *std::ranges::min_element(upper, {}, [&](int face) {
        return footPosition(extended, centreOf(face)).norm();
    });
    int far = 0;
    for (const int face : upper) {
        const Vec3 goal = footPosition(extended, centreOf(face));
        if ((goal - footPosition(extended, centreOf(start))).norm() < 0.2) {
            continue;
        }
        ++far;
        Found found{centreOf(start), {}};
        finder.move(goal, found.foot, found.frame);
        EXPECT_GT(normalOf(extended, found.foot.face).z(), 0.0) << "face " << face;
    }
    EXPECT_GT(far, 1000);
}

// ---- Many at once ----

class FeetFoundTogether : public testing::TestWithParam<Shape> {};

// From near and far, over the surface and so high that fibres cross: to the last bit.
TEST_P(FeetFoundTogether, AreThoseFoundOneByOne) {
    const Surface surface(GetParam().mesh);
    const ExtendedSurface extended = extendSurface(surface, 3);
    const PatchLevels patches(surface);
    const FibreProjector finder(extended, &patches);
    Random random(1);
    for (const int count : {0, 1, 7, 16, 17, 100}) {
        SCOPED_TRACE("points " + std::to_string(count));
        std::vector<Found> together;
        std::vector<Vec3> points;
        for (int i = 0; i < count; ++i) {
            const FootPoint goal =
                randomFoot(extended, random, (i % 3 == 0 ? 20.0 : 0.5) * meanEdge(extended));
            const bool isNear = i % 2 == 0;
            together.push_back(
                {isNear ? centreOf(goal.face) : randomFoot(extended, random, 0.0), {}}
            );
            points.push_back(pointOver(extended, goal));
        }
        std::vector<Found> single = together;
        std::vector<FibreProjector::Move> moves;
        for (std::size_t i = 0; i < points.size(); ++i) {
            moves.push_back({points[i], &together[i].foot, &together[i].frame});
            finder.move(points[i], single[i].foot, single[i].frame);
        }
        finder.moveAll(moves);
        for (std::size_t i = 0; i < points.size(); ++i) {
            SCOPED_TRACE("point " + std::to_string(i));
            EXPECT_EQ(together[i].foot.face, single[i].foot.face);
            EXPECT_EQ(together[i].foot.u, single[i].foot.u);
            EXPECT_EQ(together[i].foot.v, single[i].foot.v);
            EXPECT_EQ(together[i].foot.height, single[i].foot.height);
            EXPECT_EQ(together[i].frame.direction, single[i].frame.direction);
            EXPECT_EQ(together[i].frame.height, single[i].frame.height);
            EXPECT_EQ(together[i].frame.u, single[i].frame.u);
            EXPECT_EQ(together[i].frame.turnV, single[i].frame.turnV);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    Shapes,
    FeetFoundTogether,
    testing::Values(
        Shape{"Sphere", withNoise(icosphere(5), 0.001, 7)},
        Shape{"Torus", torus(36, 16)},
        Shape{"Plate", jitteredPlate(12, 12, 0.25, 5)},
        Shape{"Box", box(6, {1.0, 0.8, 0.6})}
    ),
    [](const auto& testInfo) { return testInfo.param.name; }
);

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
