// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/self_intersection.h"

#include "surface/predicates.h"
#include "surface/triangle_tree.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>

namespace bspline_curve {

namespace {

/// The corners of a triangle, in any order: nothing here depends on its orientation.
using Corners = std::array<const Vec3*, 3>;

/// The axis along which a triangle looks largest, up to rounding.
int broadestAxis(const Corners& t) {
    const Vec3 normal = (*t[1] - *t[0]).cross(*t[2] - *t[0]);
    int axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    return axis;
}

/// A coordinate axis along which a triangle with area projects to one with area.
int projectableAxis(const Corners& t) {
    int axis = broadestAxis(t);
    for (int k = 0; k < 2 && projectedOrientationSign(*t[0], *t[1], *t[2], axis) == 0; ++k) {
        axis = (axis + 1) % 3;
    }
    return axis;
}

/// Whether the closed segments (p, q) and (a, b) of one plane meet, seen along an axis.
bool coplanarSegmentsMeet(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, int axis) {
    const int aSide = projectedOrientationSign(p, q, a, axis);
    const int bSide = projectedOrientationSign(p, q, b, axis);
    if (aSide * bSide > 0) {
        return false;
    }
    const int pSide = projectedOrientationSign(a, b, p, axis);
    const int qSide = projectedOrientationSign(a, b, q, axis);
    if (pSide * qSide > 0) {
        return false;
    }
    if (aSide != 0 || bSide != 0 || pSide != 0 || qSide != 0) {
        return true;
    }
    // On one line: they meet where their intervals do, on every axis.
    for (int k = 0; k < 3; ++k) {
        if (std::max(p[k], q[k]) < std::min(a[k], b[k]) ||
            std::max(a[k], b[k]) < std::min(p[k], q[k])) {
            return false;
        }
    }
    return true;
}

/// Whether three signs are all >= 0 or all <= 0.
bool noOppositeSigns(int s0, int s1, int s2) {
    return std::min({s0, s1, s2}) >= 0 || std::max({s0, s1, s2}) <= 0;
}

/// Whether a closed segment meets a closed triangle of the same plane.
bool coplanarSegmentMeetsTriangle(const Vec3& p, const Vec3& q, const Corners& t) {
    const int axis = projectableAxis(t);
    // Either an end lies inside, or the segment meets an edge.
    const bool startsInside = noOppositeSigns(
        projectedOrientationSign(*t[0], *t[1], p, axis),
        projectedOrientationSign(*t[1], *t[2], p, axis),
        projectedOrientationSign(*t[2], *t[0], p, axis)
    );
    return startsInside || coplanarSegmentsMeet(p, q, *t[0], *t[1], axis) ||
           coplanarSegmentsMeet(p, q, *t[1], *t[2], axis) ||
           coplanarSegmentsMeet(p, q, *t[2], *t[0], axis);
}

/// Whether the closed segment (p, q) meets a closed triangle; pSide and qSide are the sides of the
/// triangle's plane on which its ends lie.
bool segmentMeetsTriangle(const Vec3& p, int pSide, const Vec3& q, int qSide, const Corners& t) {
    if (pSide * qSide > 0) {
        return false;
    }
    if (pSide == 0 && qSide == 0) {
        return coplanarSegmentMeetsTriangle(p, q, t);
    }
    // The segment has one point in the plane, and so has its line: it is inside if the line passes
    // all edges on the same side.
    const int side0 = orientationSign(p, q, *t[0], *t[1]);
    const int side1 = orientationSign(p, q, *t[1], *t[2]);
    return side0 * side1 >= 0 && noOppositeSigns(side0, side1, orientationSign(p, q, *t[2], *t[0]));
}

int side(const Corners& plane, const Vec3& point) {
    return orientationSign(*plane[0], *plane[1], *plane[2], point);
}

bool boxesOverlap(const Corners& a, const Corners& b) {
    for (int k = 0; k < 3; ++k) {
        const auto [aLow, aHigh] = std::minmax({(*a[0])[k], (*a[1])[k], (*a[2])[k]});
        const auto [bLow, bHigh] = std::minmax({(*b[0])[k], (*b[1])[k], (*b[2])[k]});
        if (aHigh < bLow || bHigh < aLow) {
            return false;
        }
    }
    return true;
}

/// Whether some edge of a triangle meets another triangle, given the sides of its corners.
bool anyEdgeMeets(const Corners& edgesOf, const std::array<int, 3>& sides, const Corners& t) {
    return segmentMeetsTriangle(*edgesOf[0], sides[0], *edgesOf[1], sides[1], t) ||
           segmentMeetsTriangle(*edgesOf[1], sides[1], *edgesOf[2], sides[2], t) ||
           segmentMeetsTriangle(*edgesOf[2], sides[2], *edgesOf[0], sides[0], t);
}

/// No shared vertex. Two triangles meet exactly where an edge of one meets the other.
bool disjointTrianglesMeet(const Corners& a, const Corners& b) {
    const auto sidesOf = [](const Corners& corners, const Corners& plane) {
        return std::array<int, 3>{
            side(plane, *corners[0]), side(plane, *corners[1]), side(plane, *corners[2])
        };
    };
    const auto allOnOneSide = [](const std::array<int, 3>& sides) {
        return sides[0] != 0 && sides[0] == sides[1] && sides[0] == sides[2];
    };
    if (!boxesOverlap(a, b)) {
        return false;
    }
    const std::array<int, 3> sidesOfA = sidesOf(a, b);
    if (allOnOneSide(sidesOfA)) {
        return false;
    }
    const bool coplanar = sidesOfA == std::array<int, 3>{0, 0, 0};
    const std::array<int, 3> sidesOfB = coplanar ? sidesOfA : sidesOf(b, a);
    if (allOnOneSide(sidesOfB)) {
        return false;
    }
    return anyEdgeMeets(a, sidesOfA, b) || anyEdgeMeets(b, sidesOfB, a);
}

/// Whether, seen along an axis, the line of a ray from a[0] to another corner of a has the rest of
/// a on one side and b strictly on the other. Shared corner a[0] = b[0].
bool someRaySeparates(const Corners& a, const Corners& b, int axis) {
    const auto turn = [&](const Vec3& p, const Vec3& q) {
        return projectedOrientationSign(*a[0], p, q, axis);
    };
    const int turnOfA = turn(*a[1], *a[2]);
    return turnOfA != 0 && ((turn(*a[1], *b[1]) == -turnOfA && turn(*a[1], *b[2]) == -turnOfA) ||
                            (turn(*a[2], *b[1]) == turnOfA && turn(*a[2], *b[2]) == turnOfA));
}

/// Shared corner a[0] = b[0]. If they have another common point, then the ray from the corner
/// through it leaves one of them through the opposite edge, inside of the other.
bool cornerTrianglesMeet(const Corners& a, const Corners& b) {
    // Most neighbours lie apart in plain view; on flat parts this saves the exact predicates.
    const int axis = broadestAxis(a);
    if (someRaySeparates(a, b, axis) || someRaySeparates(b, a, axis)) {
        return false;
    }
    const int a1Side = side(b, *a[1]);
    const int a2Side = side(b, *a[2]);
    if (a1Side * a2Side > 0) {
        return false;
    }
    const bool coplanar = a1Side == 0 && a2Side == 0;
    const int b1Side = coplanar ? 0 : side(a, *b[1]);
    const int b2Side = coplanar ? 0 : side(a, *b[2]);
    return segmentMeetsTriangle(*a[1], a1Side, *a[2], a2Side, b) ||
           segmentMeetsTriangle(*b[1], b1Side, *b[2], b2Side, a);
}

/// Shared edge a[0] a[1] = b[0] b[1]: they meet elsewhere only if folded flat onto each other, with
/// the third corners on the same side of the edge from wherever a is seen with area.
bool edgeTrianglesMeet(const Corners& a, const Corners& b) {
    const auto sideOfEdge = [&](const Vec3& point, int axis) {
        return projectedOrientationSign(*a[0], *a[1], point, axis);
    };
    const int axis = projectableAxis(a);
    return sideOfEdge(*a[2], axis) == sideOfEdge(*b[2], axis) && side(a, *b[2]) == 0;
}

}  // namespace

bool trianglesIntersect(const std::vector<Vec3>& vertices, const Triangle& a, const Triangle& b) {
    // Bring the shared vertices to the front, in the same order in both.
    Triangle first = a;
    Triangle second = b;
    std::size_t shared = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = shared; j < 3; ++j) {
            if (first[i] == second[j]) {
                std::swap(first[shared], first[i]);
                std::swap(second[shared], second[j]);
                ++shared;
                break;
            }
        }
    }
    const auto cornersOf = [&](const Triangle& triangle) {
        return Corners{&vertices[triangle[0]], &vertices[triangle[1]], &vertices[triangle[2]]};
    };
    switch (shared) {
        case 0:
            return disjointTrianglesMeet(cornersOf(first), cornersOf(second));
        case 1:
            return cornerTrianglesMeet(cornersOf(first), cornersOf(second));
        case 2:
            return edgeTrianglesMeet(cornersOf(first), cornersOf(second));
        default:
            return true;
    }
}

std::vector<std::pair<int, int>> findSelfIntersections(
    const std::vector<Vec3>& vertices, const std::vector<Triangle>& triangles
) {
    std::vector<std::pair<int, int>> pairs;
    const TriangleTree tree(vertices, triangles);
    tree.forEachOverlappingPair([&](int i, int j) {
        if (trianglesIntersect(vertices, triangles[i], triangles[j])) {
            pairs.emplace_back(i, j);
        }
    });
    std::ranges::sort(pairs);
    return pairs;
}

}  // namespace bspline_curve
