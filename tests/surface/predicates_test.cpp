// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/predicates.h"

#include "exact_oracle.h"
#include "support/random.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <string>

namespace bspline_curve {
namespace {

using exact_oracle::Point;
using test_support::Random;

Vec3 toVec3(const Point& p) {
    return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}

int orientationSignOf(const std::array<Point, 4>& p) {
    return orientationSign(toVec3(p[0]), toVec3(p[1]), toVec3(p[2]), toVec3(p[3]));
}

TEST(Predicates, OrientationIsPositiveOnTheSideOfTheRightHandedNormal) {
    const Vec3 a(0, 0, 0);
    const Vec3 b(1, 0, 0);
    const Vec3 c(0, 1, 0);
    EXPECT_EQ(orientationSign(a, b, c, Vec3(0.2, 0.2, 1.0)), 1);
    EXPECT_EQ(orientationSign(a, b, c, Vec3(0.2, 0.2, -1.0)), -1);
    EXPECT_EQ(orientationSign(a, b, c, Vec3(0.2, 0.2, 0.0)), 0);
    // The same, so close that only the exact path can tell.
    EXPECT_EQ(orientationSign(a, b, c, Vec3(1e10, 1e10, 1e-30)), 1);
    EXPECT_EQ(orientationSign(a, b, c, Vec3(1e10, 1e10, -1e-30)), -1);
}

TEST(Predicates, ExactPathHasTheSameSignConventionAsTheFastOne) {
    const Vec3 a(0, 0, 0);
    const Vec3 b(1, 0, 0);
    const Vec3 c(0, 1, 0);
    EXPECT_EQ(detail::exactOrientationSign(a, b, c, Vec3(0, 0, 1)), 1);
    EXPECT_EQ(detail::exactOrientationSign(a, b, c, Vec3(0, 0, -1)), -1);
    EXPECT_EQ(detail::exactProjectedOrientationSign(a, b, c, 2), 1);
    EXPECT_EQ(detail::exactProjectedOrientationSign(a, c, b, 2), -1);
}

TEST(Predicates, OrientationSeesOneUlpAboveAPlane) {
    // The plane x + y + z = 3/2 passes through all of these.
    const Vec3 a(0.5, 0.5, 0.5);
    const Vec3 b(12.0, -12.0, 1.5);
    const Vec3 c(24.0, 24.0, -46.5);
    const Vec3 on(0.25, 0.5, 0.75);
    const int below = orientationSign(a, b, c, Vec3(0.25, 0.5, std::nextafter(0.75, 0.0)));
    const int above = orientationSign(a, b, c, Vec3(0.25, 0.5, std::nextafter(0.75, 1.0)));
    EXPECT_EQ(orientationSign(a, b, c, on), 0);
    EXPECT_EQ(below * above, -1);
}

/// Four points far from the origin, the last on the plane of the others up to one unit.
std::array<Point, 4> nearlyCoplanarPoints(Random& random) {
    const int size = 1 << random.integer(2, 24);
    const std::int64_t offset = std::int64_t{1} << random.integer(0, 30);
    std::array<Point, 4> p{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::int64_t& coordinate : p[i]) {
            coordinate = offset + random.integer(-size, size);
        }
    }
    const std::int64_t s = random.integer(-3, 3);
    const std::int64_t t = random.integer(-3, 3);
    for (std::size_t k = 0; k < 3; ++k) {
        p[3][k] = p[0][k] + s * (p[1][k] - p[0][k]) + t * (p[2][k] - p[0][k]);
    }
    p[3][random.integer(0, 2)] += random.integer(-1, 1);
    return p;
}

TEST(Predicates, OrientationAgreesWithIntegerArithmeticOnNearlyCoplanarPoints) {
    SCOPED_TRACE("seed 1");
    Random random(1);
    int zeros = 0;
    for (int i = 0; i < 20000; ++i) {
        const std::array<Point, 4> p = nearlyCoplanarPoints(random);
        const int expected = exact_oracle::orientationSign(p[0], p[1], p[2], p[3]);
        zeros += expected == 0 ? 1 : 0;
        ASSERT_EQ(orientationSignOf(p), expected) << "case " << i;
    }
    EXPECT_GT(zeros, 1000) << "the cases should hit the coplanar one often";
}

TEST(Predicates, OrientationFollowsThePermutationOfItsPoints) {
    SCOPED_TRACE("seed 2");
    Random random(2);
    for (int i = 0; i < 2000; ++i) {
        // Decimal fractions on nearly one plane, where a plain determinant is mostly noise.
        std::array<Vec3, 4> p;
        for (Vec3& point : p) {
            const double x = 0.1 * random.integer(-30, 30);
            const double y = 0.1 * random.integer(-30, 30);
            point = Vec3(x, y, 0.3 * x + 0.7 * y);
        }
        const auto sign = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
            return orientationSign(p[a], p[b], p[c], p[d]);
        };
        const int expected = sign(0, 1, 2, 3);
        const std::array<int, 3> even = {sign(1, 2, 0, 3), sign(2, 3, 0, 1), sign(1, 0, 3, 2)};
        const std::array<int, 3> odd = {sign(1, 0, 2, 3), sign(0, 1, 3, 2), sign(3, 0, 1, 2)};
        EXPECT_EQ(even, (std::array{expected, expected, expected})) << "case " << i;
        EXPECT_EQ(odd, (std::array{-expected, -expected, -expected})) << "case " << i;
    }
}

TEST(Predicates, ProjectedOrientationIsTheSignOfTheNormalsComponent) {
    SCOPED_TRACE("seed 3");
    Random random(3);
    for (int i = 0; i < 20000; ++i) {
        const int size = 1 << random.integer(1, 20);
        const std::int64_t offset = std::int64_t{1} << random.integer(0, 40);
        std::array<Point, 3> p{};
        for (std::size_t k = 0; k < 3; ++k) {
            p[0][k] = random.integer(-size, size) + offset;
            p[1][k] = random.integer(-size, size) + offset;
            // Collinear up to a step of at most one unit.
            p[2][k] = p[0][k] + 3 * (p[1][k] - p[0][k]) + random.integer(-1, 1);
        }
        for (int axis = 0; axis < 3; ++axis) {
            const auto x = static_cast<std::size_t>((axis + 1) % 3);
            const auto y = static_cast<std::size_t>((axis + 2) % 3);
            const std::int64_t area = (p[1][x] - p[0][x]) * (p[2][y] - p[0][y]) -
                                      (p[1][y] - p[0][y]) * (p[2][x] - p[0][x]);
            const int expected = (area > 0 ? 1 : 0) - (area < 0 ? 1 : 0);
            ASSERT_EQ(
                projectedOrientationSign(toVec3(p[0]), toVec3(p[1]), toVec3(p[2]), axis), expected
            ) << "case "
              << i << ", axis " << axis;
        }
    }
}

TEST(Predicates, AreExactAtVerySmallAndVeryLargeScales) {
    const Vec3 a(1, 2, 3);
    const Vec3 b(4, -1, 3);
    const Vec3 c(-2, 5, 4);
    const Vec3 inPlane = a + 2.0 * (b - a) - 3.0 * (c - a);
    for (const double scale : {0x1p-100, 0x1p-40, 1.0, 0x1p40, 0x1p190}) {
        const Vec3 above = inPlane + 0x1p-40 * Vec3::UnitX();
        EXPECT_EQ(orientationSign(scale * a, scale * b, scale * c, scale * inPlane), 0) << scale;
        EXPECT_EQ(
            orientationSign(scale * a, scale * b, scale * c, scale * above),
            (b - a).cross(c - a)[0] > 0 ? 1 : -1
        ) << scale;
    }
}

}  // namespace
}  // namespace bspline_curve
