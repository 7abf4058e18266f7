// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/check/exact_overlap.h"

#include "support/seeds.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

namespace bspline_curve {
namespace {

using test_support::forEachSeed;
using test_support::Random;

// ---- An oracle in integers: the triangle clipped by the four planes of the tetrahedron ----

using Integer = std::int64_t;
using Homogeneous = std::array<Integer, 3>;  // barycentrics in the triangle, up to a factor

Integer determinant(const Homogeneous& a, const Homogeneous& b, const Homogeneous& c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
}

Integer volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    return static_cast<Integer>((b - a).cross(c - a).dot(d - a));
}

Integer dot(const Homogeneous& a, const Homogeneous& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// The part of a polygon where side . vertex >= 0.
std::vector<Homogeneous> clipped(const std::vector<Homogeneous>& polygon, const Homogeneous& side) {
    std::vector<Homogeneous> result;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Homogeneous& p = polygon[i];
        const Homogeneous& q = polygon[(i + 1) % polygon.size()];
        const Integer pSide = dot(p, side);
        const Integer qSide = dot(q, side);
        if (pSide >= 0) {
            result.push_back(p);
        }
        if ((pSide > 0 && qSide < 0) || (pSide < 0 && qSide > 0)) {
            Homogeneous crossing{};
            Integer factor = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                crossing[k] = std::abs(qSide) * p[k] + std::abs(pSide) * q[k];
                factor = std::gcd(factor, crossing[k]);
            }
            for (Integer& x : crossing) {
                x /= factor;
            }
            result.push_back(crossing);
        }
    }
    return result;
}

bool oracle(const std::array<Vec3, 4>& tet, const std::array<Vec3, 3>& triangle) {
    std::vector<Homogeneous> polygon = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (std::size_t k = 0; k < 4; ++k) {
        const Vec3& a = tet[(k + 1) % 4];
        const Vec3& b = tet[(k + 2) % 4];
        const Vec3& c = tet[(k + 3) % 4];
        const Integer inside = volume(a, b, c, tet[k]) > 0 ? 1 : -1;
        polygon = clipped(
            polygon,
            {inside * volume(a, b, c, triangle[0]),
             inside * volume(a, b, c, triangle[1]),
             inside * volume(a, b, c, triangle[2])}
        );
    }
    for (std::size_t i = 2; i < polygon.size(); ++i) {
        if (determinant(polygon[0], polygon[i - 1], polygon[i]) != 0) {
            return true;
        }
    }
    return false;
}

// Small coordinates make most configurations degenerate in some way.
TEST(ExactOverlap, AgreesWithClippingInIntegers) {
    int overlapping = 0;
    int flat = 0;
    forEachSeed(100, [&](Random& random) {
        const int size = random.integer(1, 5);
        const auto point = [&]() -> Vec3 {
            const int x = random.integer(0, size);
            const int y = random.integer(0, size);
            const int z = random.integer(0, size);
            return {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
        };
        for (int i = 0; i < 2000; ++i) {
            const std::array<Vec3, 4> tet = {point(), point(), point(), point()};
            const std::array<Vec3, 3> triangle = {point(), point(), point()};
            if ((triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]).isZero(0.0)) {
                continue;
            }
            const bool isFlat = volume(tet[0], tet[1], tet[2], tet[3]) == 0;
            const bool expected = !isFlat && oracle(tet, triangle);
            EXPECT_EQ(overlaps(tet, triangle), expected);
            overlapping += expected ? 1 : 0;
            flat += isFlat ? 1 : 0;
        }
    });
    EXPECT_GT(overlapping, 10000);
    EXPECT_GT(flat, 1000);
}

TEST(ExactOverlap, TakesTrianglesWithoutAreaForSegments) {
    const std::array<Vec3, 4> tet = {
        Vec3::Zero(), 4.0 * Vec3::UnitX(), 4.0 * Vec3::UnitY(), 4.0 * Vec3::UnitZ()
    };
    const auto segmentOverlaps = [&](const Vec3& a, const Vec3& b) {
        return overlaps(tet, {a, b, b});
    };
    EXPECT_TRUE(segmentOverlaps({-1, 1, 1}, {5, 1, 1}));
    EXPECT_TRUE(segmentOverlaps({1, 1, 1}, {1, 1, 1}));
    EXPECT_TRUE(segmentOverlaps({-1, 1, 0}, {5, 1, 0}));   // through the inside of a face
    EXPECT_FALSE(segmentOverlaps({-1, 0, 0}, {5, 0, 0}));  // along an edge
    EXPECT_FALSE(segmentOverlaps({1, 1, -1}, {1, 1, 0}));  // up to a face
    EXPECT_FALSE(segmentOverlaps({3, 3, 0}, {3, 0, 3}));   // beyond a face
}

TEST(ExactOverlap, FindsTheSignOfADotProductThatRoundsToZero) {
    // Normal (1, -1, 0); the differences of the ends round to (1, 1, 0).
    const std::array<Vec3, 3> triangle = {Vec3(0, 0, 0), Vec3(1, 1, 0), Vec3(0, 0, 1)};
    const double tiny = 0x1p-60;
    EXPECT_EQ(normalDotSign(triangle, {tiny, tiny, 0.0}, {1.0, 1.0, 0.0}), 0);
    EXPECT_EQ(normalDotSign(triangle, {tiny, 0.5 * tiny, 0.0}, {1.0, 1.0, 0.0}), -1);
    EXPECT_EQ(normalDotSign(triangle, {0.5 * tiny, tiny, 0.0}, {1.0, 1.0, 0.0}), 1);
    EXPECT_EQ(normalDotSign(triangle, {0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}), 0);
    // The same with corners whose differences are not exact.
    const std::array<Vec3, 3> moved = {Vec3(tiny, tiny, 0), Vec3(1, 1, 0), Vec3(tiny, tiny, 1)};
    EXPECT_EQ(normalDotSign(moved, {tiny, tiny, 0.0}, {1.0, 1.0, 0.0}), 0);
    EXPECT_EQ(normalDotSign(moved, {tiny, 0.5 * tiny, 0.0}, {1.0, 1.0, 0.0}), -1);
}

TEST(ExactOverlap, FindsTheSignOfDotProductsOfIntegers) {
    forEachSeed(2000, [&](Random& random) {
        const auto vector = [&]() -> Vec3 { return random.point(-1e5, 1e5).array().round(); };
        const Vec3 a = vector();
        const Vec3 u = vector();
        const Vec3 v = vector();
        // Almost in the plane of u and v.
        Vec3 w = random.integer(-9, 9) * u + random.integer(-9, 9) * v;
        w[random.integer(0, 2)] += random.integer(-1, 1);
        const Vec3 from = vector();
        __extension__ typedef __int128 Wide;  // NOLINT(modernize-use-using): needs __extension__
        Wide expected = 0;
        for (int i = 0; i < 3; ++i) {
            const auto part = [](double x) { return static_cast<Wide>(x); };
            const int j = (i + 1) % 3;
            const int k = (i + 2) % 3;
            expected += part(w[i]) * (part(u[j]) * part(v[k]) - part(u[k]) * part(v[j]));
        }
        EXPECT_EQ(
            normalDotSign({a, a + u, a + v}, from, from + w),
            (expected > 0 ? 1 : 0) - (expected < 0 ? 1 : 0)
        );
    });
}

}  // namespace
}  // namespace bspline_curve
