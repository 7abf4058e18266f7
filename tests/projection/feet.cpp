// SPDX-License-Identifier: GPL-3.0-or-later
#include "projection/feet.h"

#include "surface/closest_point.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace bspline_curve::test_support {
namespace {

Vec3 combine(const std::vector<Vec3>& values, const Triangle& face, const Vec3& weights) {
    return weights[0] * values[face[0]] + weights[1] * values[face[1]] +
           weights[2] * values[face[2]];
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

}  // namespace

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

Found find(const ExtendedSurface& extended, const Vec3& p, const FootPoint& start) {
    Found found{start, {}};
    FibreProjector(extended).move(p, found.foot, found.frame);
    return found;
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

}  // namespace bspline_curve::test_support
