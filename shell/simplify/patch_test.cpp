// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/simplify/patch_test.h"

#include "shell/projection_stretch.h"
#include "surface/predicates.h"
#include "surface/self_intersection.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace bspline_curve {
namespace {

// Share of the way from the middle to top and bottom that faces may reach: heights stay below 1.
constexpr double kSurfaceMargin = 0.85;

// Least cosine between the half pillars of a tetrahedron and the normals of the faces that meet it.
constexpr float kLeastCosine = 0.03F + kFloatMargin;

float dot(const std::array<float, 3>& a, const std::array<float, 3>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

std::array<float, 3> toFloat(const Vec3& v) {
    return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}

FloatPlane planeOf(const Vec3& normal, double offset, float margin) {
    const std::array<float, 3> n = toFloat(normal);
    return {n[0], n[1], n[2], static_cast<float>(offset) + margin};
}

using TetCorners = std::array<const Vec3*, 4>;
using FaceCorners = std::array<const Vec3*, 3>;

// How far apart a tetrahedron and a triangle are along an axis, in units of the axis' length in the
// 1-norm; negative where they overlap.
double gapAlong(const Vec3& axis, const TetCorners& tet, const FaceCorners& face) {
    double lowA = std::numeric_limits<double>::infinity();
    double highA = -lowA;
    double lowB = lowA;
    double highB = -lowA;
    const Vec3& first = *tet[0];
    for (const Vec3* p : tet) {
        const double x = axis.dot(*p - first);
        lowA = std::min(lowA, x);
        highA = std::max(highA, x);
    }
    for (const Vec3* p : face) {
        const double x = axis.dot(*p - first);
        lowB = std::min(lowB, x);
        highB = std::max(highB, x);
    }
    const double size = axis.cwiseAbs().sum();
    return size > 0.0 ? std::max(lowB - highA, lowA - highB) / size
                      : -std::numeric_limits<double>::infinity();
}

// The largest gap along the axes that separate disjoint ones, or the first above `enough`.
double largestGap(const TetCorners& tet, const FaceCorners& face, double enough) {
    constexpr std::array<std::array<int, 2>, 6> kEdges = {
        {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}
    };
    constexpr std::array<Triangle, 4> kFaces = {{{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}}};
    const std::array<Vec3, 3> edges = {
        *face[1] - *face[0], *face[2] - *face[1], *face[0] - *face[2]
    };
    double gap = gapAlong(edges[0].cross(edges[1]), tet, face);
    for (std::size_t i = 0; i < 4 && gap <= enough; ++i) {
        const Vec3& first = *tet[kFaces[i][0]];
        const Vec3 normal = (*tet[kFaces[i][1]] - first).cross(*tet[kFaces[i][2]] - first);
        gap = std::max(gap, gapAlong(normal, tet, face));
    }
    for (std::size_t i = 0; i < 18 && gap <= enough; ++i) {
        const std::array<int, 2>& e = kEdges[i / 3];
        const Vec3 along = *tet[e[1]] - *tet[e[0]];
        gap = std::max(gap, gapAlong(along.cross(edges[i % 3]), tet, face));
    }
    return gap;
}

// Whether the plane through three of the points has the tetrahedron on one side and the triangle on
// the other, so that they touch at most in a common edge (exact).
bool touchAlong(const std::array<const Vec3*, 7>& points, const std::array<std::size_t, 3>& plane) {
    std::array<int, 7> sides{};
    for (std::size_t i = 0; i < 7; ++i) {
        const bool isOn = i == plane[0] || i == plane[1] || i == plane[2];
        sides[i] = isOn ? 0
                        : orientationSign(
                              *points[plane[0]], *points[plane[1]], *points[plane[2]], *points[i]
                          );
    }
    const auto [lowTet, highTet] = std::minmax({sides[0], sides[1], sides[2], sides[3]});
    const auto [lowFace, highFace] = std::minmax({sides[4], sides[5], sides[6]});
    const bool apart = (lowTet >= 0 && highFace <= 0) || (highTet <= 0 && lowFace >= 0);
    const auto onPlane = std::count(sides.begin(), sides.begin() + 4, 0);
    return apart && lowTet != highTet && (onPlane < 3 || lowFace != highFace);
}

// Whether a tetrahedron and a triangle that touch do so at most in a common edge (exact; false
// where no plane through three of their corners shows it).
bool touchInEdge(const TetCorners& tet, const FaceCorners& face) {
    const std::array<const Vec3*, 7> points = {
        tet[0], tet[1], tet[2], tet[3], face[0], face[1], face[2]
    };
    for (std::size_t i = 0; i < 7; ++i) {
        for (std::size_t j = i + 1; j < 7; ++j) {
            for (std::size_t k = j + 1; k < 7; ++k) {
                if (touchAlong(points, {i, j, k})) {
                    return true;
                }
            }
        }
    }
    return false;
}

// Whether a tetrahedron and a triangle have at most an edge in common. Where that is so, the fibres
// in the tetrahedron pass the triangle nowhere.
bool areApart(const TetCorners& tet, const FaceCorners& face) {
    // Rounding of gaps is below the first; a gap below minus the second is an overlap.
    constexpr double kRounding = 1e-14;
    constexpr double kTouching = 1e-12;
    const double gap = largestGap(tet, face, kRounding);
    return gap > kRounding || (gap > -kTouching && touchInEdge(tet, face));
}

// Faces seen at less than these by the fibres of each tetrahedron would be stretched too much.
std::array<float, kTetrahedraPerPrism> leastCosinesOf(
    const std::array<Gram, kTetrahedraPerPrism>& grams
) {
    std::array<float, kTetrahedraPerPrism> cosines{};
    cosines.fill(kLeastCosine);
    double largest = 0.0;
    double steepest = 0.0;
    for (const Gram& gram : grams) {
        const double determinant = gram.determinant();
        largest = std::max(largest, gram.trace());
        steepest = determinant > 0.0 ? std::max(steepest, gram.trace() / determinant)
                                     : std::numeric_limits<double>::infinity();
    }
    // Most prisms stretch so little that this bound is enough.
    constexpr double kUsualStretch = static_cast<double>(kLeastCosine) * kMostStretch;
    if (largest * steepest <= kUsualStretch * kUsualStretch) {
        return cosines;
    }
    for (std::size_t i = 0; i < cosines.size(); ++i) {
        const double needed = largestStretch(grams, grams[i]) / kMostStretch;
        cosines[i] =
            needed < 1.0 ? std::max(kLeastCosine, static_cast<float>(needed) + kFloatMargin) : 2.0F;
    }
    return cosines;
}

}  // namespace

bool PatchTest::isPositive(const Triangle& pillars) const {
    const Triangle slots = slotsOf(pillars);
    const int orientation = orientationOf(pillars);
    return Slab{complex_.points, slots, orientation, 0}.isPositive() &&
           Slab{complex_.points, slots, orientation, 1}.isPositive();
}

PatchTest::Sides PatchTest::sidesOf(const Triangle& slots, const Triangle& pillars) const {
    Sides sides;
    std::array<Pillar, 3> p;
    for (std::size_t k = 0; k < 3; ++k) {
        p[k] = complex_.points.pillar(pillars[k]);
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const Pillar& a = p[k];
        const Pillar& b = p[(k + 1) % 3];
        const Vec3 normal =
            (b.middle - a.middle).cross((a.top - a.bottom) + (b.top - b.bottom)).normalized();
        double farthest = -std::numeric_limits<double>::infinity();
        for (const Pillar& pillar : p) {
            farthest = std::max(
                {farthest,
                 normal.dot(pillar.bottom),
                 normal.dot(pillar.middle),
                 normal.dot(pillar.top)}
            );
        }
        sides.walls[k] = planeOf(normal, farthest, kFloatMargin);
    }
    for (std::size_t k = 0; k < 3; ++k) {
        sides.layers[0][k] = p[k].middle + kSurfaceMargin * (p[k].top - p[k].middle);
        sides.layers[1][k] = p[k].middle + kSurfaceMargin * (p[k].bottom - p[k].middle);
    }
    for (const int slab : {0, 1}) {
        const auto& [a, b, c] = sides.layers[slab];
        const Vec3 normal = (slab == 0 ? 1.0 : -1.0) * (b - a).cross(c - a).normalized();
        sides.layerPlanes[slab] = planeOf(normal, normal.dot(a), -kFloatMargin);
    }
    std::array<Pillar, 3> bySlot;
    for (std::size_t k = 0; k < 3; ++k) {
        bySlot[k] = complex_.points.pillar(slots[k]);
    }
    std::array<Gram, kTetrahedraPerPrism> grams;
    for (const std::size_t slab : {0U, 1U}) {
        const std::array<Vec3, 3> fibres = fibresOf(bySlot, slab);
        std::ranges::copy(gramsOf(bySlot, fibres, slab), grams.begin() + 3 * slab);
        std::ranges::transform(fibres, sides.halves.begin() + 3 * slab, toFloat);
    }
    sides.leastCosines = leastCosinesOf(grams);
    return sides;
}

bool PatchTest::isBeyond(int face, const FloatPlane& wall) const {
    for (std::size_t k = 0; k < 3; ++k) {
        if (wall.at(toFloat(surface_.corner(face, k))) <= 0.0F) {
            return false;
        }
    }
    return true;
}

bool PatchTest::meetsTetrahedron(int face, const Triangle& slots, int slab, int tet) const {
    return !areApart(
        Slab{complex_.points, slots, 1, slab}.corners(tet),
        {&surface_.corner(face, 0), &surface_.corner(face, 1), &surface_.corner(face, 2)}
    );
}

bool PatchTest::isTransversal(int face, const Triangle& slots, const Sides& sides) const {
    const std::array<float, 3>& normal = surface_.bounds[face].normal;
    for (std::size_t half = 0; half < sides.halves.size(); ++half) {
        // The fibres of a tetrahedron run along the half pillar that it holds.
        const int slab = static_cast<int>(half) / 3;
        const int tet = 2 - static_cast<int>(half) % 3;
        if (dot(normal, sides.halves[half]) < sides.leastCosines[half] &&
            meetsTetrahedron(face, slots, slab, tet)) {
            return false;
        }
    }
    return true;
}

bool PatchTest::reaches(int face, const Sides& sides, int slab) {
    const FaceBound& bound = surface_.bounds[face];
    if (sides.layerPlanes[slab].at(bound.centre) <= -bound.radius) {
        return false;
    }
    for (std::size_t k = 0; k < 3; ++k) {
        scratch_[k] = sides.layers[slab][k];
        scratch_[3 + k] = surface_.corner(face, k);
    }
    return trianglesIntersect(scratch_, {0, 1, 2}, {3, 4, 5});
}

bool PatchTest::accepts(std::span<const Triangle> prisms, std::span<const int> faces) {
    tracked_.clear();
    trackedFirst_.assign(1, 0);
    for (const Triangle& pillars : prisms) {
        const Triangle slots = slotsOf(pillars);
        const Sides sides = sidesOf(slots, pillars);
        for (const int face : faces) {
            const FaceBound& bound = surface_.bounds[face];
            const float d0 = sides.walls[0].at(bound.centre);
            const float d1 = sides.walls[1].at(bound.centre);
            const float d2 = sides.walls[2].at(bound.centre);
            const float farthest = std::max({d0, d1, d2});
            if (farthest > bound.radius ||
                (farthest > -bound.radius && ((d0 > 0.0F && isBeyond(face, sides.walls[0])) ||
                                              (d1 > 0.0F && isBeyond(face, sides.walls[1])) ||
                                              (d2 > 0.0F && isBeyond(face, sides.walls[2]))))) {
                continue;
            }
            if (!isTransversal(face, slots, sides) || reaches(face, sides, 0) ||
                reaches(face, sides, 1)) {
                return false;
            }
            tracked_.push_back(face);
        }
        trackedFirst_.push_back(static_cast<int>(tracked_.size()));
    }
    return true;
}

}  // namespace bspline_curve
