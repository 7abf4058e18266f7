// SPDX-License-Identifier: GPL-3.0-or-later
// Feet of points over surfaces: P = q + height n(q), wherever the fibres allow it, and the nearest
// point nearby elsewhere.
#include "projection/fibre_projector.h"

#include "projection/feet.h"
#include "support/meshes.h"
#include "surface/patch_levels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace bspline_curve {
namespace {

using namespace test_support;

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

TEST_P(FeetNear, ThatStayInTheirFaceHaveTheFramesOfWalks) {
    const FibreProjector finder(extended_);
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const FootPoint foot = randomFoot(extended_, random, 0.0);
        const Found walked = find(extended_, footPosition(extended_, foot), foot);
        ASSERT_EQ(walked.foot.face, foot.face);
        FootFrame frame;
        ASSERT_TRUE(finder.stayInFace(foot, frame));
        EXPECT_LT((frame.u - walked.frame.u).norm() * edge_, 1e-9);
        EXPECT_LT((frame.v - walked.frame.v).norm() * edge_, 1e-9);
        EXPECT_LT((frame.height - walked.frame.height).norm(), 1e-9);
        EXPECT_LT((frame.direction - walked.frame.direction).norm(), 1e-9);
        EXPECT_FALSE(finder.stayInFace({foot.face, foot.u, -1e-12, 0.0}, frame));
        EXPECT_FALSE(finder.stayInFace({foot.face, 0.6, 0.5, 0.0}, frame));
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
        static_cast<void>(finder.moveAll(moves));
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

}  // namespace
}  // namespace bspline_curve
