// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/pillar_directions.h"

#include "shell/extended_surface.h"
#include "support/seeds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace bspline_curve {
namespace {

using test_support::forEachSeed;
using test_support::Random;

Vec3 randomDirection(Random& random) {
    while (true) {
        const Vec3 p = random.point(-1.0, 1.0);
        if (p.norm() > 0.1 && p.norm() < 1.0) {
            return p.normalized();
        }
    }
}

// The best direction of many, refined by steps that halve where they fail.
double searchedCosine(const std::vector<Vec3>& normals, Random& random) {
    Vec3 best = Vec3::UnitZ();
    double cosine = leastCosine(best, normals);
    const auto offer = [&](const Vec3& candidate) {
        const double found = leastCosine(candidate, normals);
        if (found > cosine) {
            cosine = found;
            best = candidate;
            return true;
        }
        return false;
    };
    for (int i = 0; i < 2000; ++i) {
        offer(randomDirection(random));
    }
    for (double step = 0.1; step > 1e-8; step *= 0.5) {
        for (int i = 0; i < 60; ++i) {
            offer((best + step * randomDirection(random)).normalized());
        }
    }
    return cosine;
}

// Normals within an angle of a random axis.
std::vector<Vec3> randomNormals(int count, double angle, Random& random) {
    const Vec3 axis = randomDirection(random);
    std::vector<Vec3> normals;
    while (static_cast<int>(normals.size()) < count) {
        const Vec3 normal = randomDirection(random);
        if (normal.dot(axis) >= std::cos(angle)) {
            normals.push_back(normal);
        }
    }
    return normals;
}

TEST(DirectionOfLeastAngle, IsAsGoodAsAnySearchFinds) {
    forEachSeed(150, [&](Random& random) {
        const std::vector<Vec3> normals =
            randomNormals(random.integer(1, 40), random.uniform(0.3, 3.0), random);
        const Vec3 direction = directionOfLeastAngle(normals);
        EXPECT_NEAR(direction.norm(), 1.0, 1e-12);
        const double searched = searchedCosine(normals, random);
        if (searched > 1e-6) {
            EXPECT_GE(leastCosine(direction, normals), searched - 1e-12);
        } else {
            EXPECT_LE(leastCosine(direction, normals), 1e-6);
        }
    });
}

TEST(DirectionOfLeastAngle, IsTheOnlyNormal) {
    const Vec3 normal = Vec3(1, 2, 3).normalized();
    EXPECT_EQ(directionOfLeastAngle(std::vector<Vec3>{normal}), normal);
    const std::vector<Vec3> thrice(3, normal);
    EXPECT_NEAR(leastCosine(directionOfLeastAngle(thrice), thrice), 1.0, 1e-15);
}

TEST(DirectionOfLeastAngle, IsTheBisectorTheDiagonalOrTheAxis) {
    const auto expectDirection = [](const std::vector<Vec3>& normals, const Vec3& expected) {
        EXPECT_LT((directionOfLeastAngle(normals) - expected).norm(), 1e-12);
    };
    expectDirection({Vec3::UnitX(), Vec3::UnitY()}, Vec3(1, 1, 0).normalized());
    expectDirection({Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()}, Vec3(1, 1, 1).normalized());
    for (const int count : {3, 4, 7, 40, 3000}) {
        std::vector<Vec3> steepCone;
        for (int i = 0; i < count; ++i) {
            const double angle = 2.0 * M_PI * i / count;
            steepCone.push_back(Vec3(std::cos(angle), std::sin(angle), 0.1).normalized());
        }
        expectDirection(steepCone, Vec3::UnitZ());
    }
}

TEST(DirectionOfLeastAngle, IsAUnitVectorThatSeesNothingWhereNoneDoes) {
    const Vec3 x = Vec3::UnitX();
    const Vec3 y = Vec3::UnitY();
    const Vec3 z = Vec3::UnitZ();
    const std::vector<std::vector<Vec3>> cases = {
        {x, -x}, {x, -x, y}, {x, -x, y, -y, z, -z}, {x + y + z, x - y - z, y - x - z, z - x - y}
    };
    for (std::vector<Vec3> normals : cases) {
        std::ranges::for_each(normals, [](Vec3& normal) { normal.normalize(); });
        const Vec3 direction = directionOfLeastAngle(normals);
        EXPECT_NEAR(direction.norm(), 1.0, 1e-12);
        EXPECT_LE(leastCosine(direction, normals), 1e-15);
    }
}

TEST(DirectionOfLeastAngle, DoesNotDependOnTheOrderOfTheNormals) {
    forEachSeed(50, [&](Random& random) {
        std::vector<Vec3> normals = randomNormals(6, 1.2, random);
        const Vec3 direction = directionOfLeastAngle(normals);
        std::rotate(normals.begin(), normals.begin() + random.integer(0, 5), normals.end());
        EXPECT_LT((directionOfLeastAngle(normals) - direction).norm(), 1e-9);
    });
}

TEST(LeastCosine, IsTheSmallest) {
    EXPECT_EQ(leastCosine(Vec3::UnitX(), {}), 1.0);
    const std::vector<Vec3> normals = {Vec3::UnitX(), Vec3(0.6, 0.8, 0.0), Vec3(0.8, 0.0, 0.6)};
    EXPECT_EQ(leastCosine(Vec3::UnitX(), normals), 0.6);
}

// Of the tip of an extruded wire: the edge of length 0.05 ends in a face that folds back, and the
// other vertices lie 20 away.
TEST(MovedVertices, StayNearAmongNeedles) {
    const Surface surface(
        TriangleMesh{
            {{8e-06, -10, -10},
             {6e-06, -10, 10},
             {6e-06, -9.951848, 10},
             {0.98018, -9.951847, -10}},
            {{0, 1, 2}, {1, 0, 3}, {3, 2, 1}}
        }
    );
    const ExtendedSurface extended = extendSurface(surface, 3);
    EXPECT_TRUE(extended.unseenVertices.empty());
    EXPECT_FALSE(extended.movedVertices.empty());
    for (const int v : extended.movedVertices) {
        const Vec3 moved = extended.frame.toUser(extended.vertices[v]);
        EXPECT_LT((moved - surface.vertices()[v]).norm(), 0.1);
    }
}

}  // namespace
}  // namespace bspline_curve
