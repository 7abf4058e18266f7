// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/obstacles.h"

#include "surface/distance_to_region.h"

#include <algorithm>
#include <limits>

namespace bspline_curve {
namespace {

// J falls by no more than this at the middle of an edge with both ends on the region: three such
// edges leave 0 in the middle of their face.
constexpr double kDeepestBulge = 0.75;
// A point of an edge keeps at least this share of the clearance that the edge has at most.
constexpr double kKeptShare = 0.5;

}  // namespace

Obstacles::Obstacles(
    const Surface& surface, const ExtendedSurface& extended, const Region& region, double margin
)
    : extended_(extended), kinds_(extended.faces.size(), Kind::Far) {
    for (const double distance : distancesToRegion(surface, region, margin)) {
        values_.push_back(1.0 - distance / margin);
    }
    for (const int source : extended.ghostSource) {
        values_.push_back(values_[source]);
    }
    for (const int f : region) {
        kinds_[f] = Kind::Avoided;
    }
    for (std::size_t f = 0; f < extended.faces.size(); ++f) {
        // A ghost collapses onto an edge of the face that it leads to.
        int inner = static_cast<int>(f);
        while (inner >= extended.surfaceFaceCount) {
            inner = extended.faceNeighbours[inner][2];
        }
        if (kinds_[inner] == Kind::Avoided) {
            kinds_[f] = Kind::Avoided;
            continue;
        }
        const Triangle& corners = extended.faces[f];
        if (std::ranges::any_of(corners, [&](int v) { return values_[v] > 0.0; })) {
            kinds_[f] = Kind::Affine;
        }
        Bulges bulges{};
        for (std::size_t k = 0; k < 3; ++k) {
            const int v = extended.surfaceVertex(corners[(k + 1) % 3]);
            const int w = extended.surfaceVertex(corners[(k + 2) % 3]);
            const int behind = extended.faceNeighbours[f][k];
            const bool isFree = behind < 0 || kinds_[behind] != Kind::Avoided;
            if (isFree && v != w && values_[v] == 1.0 && values_[w] == 1.0) {
                const Vec3 edge = surface.vertices()[v] - surface.vertices()[w];
                // The middle of the edge is half its length away from the region.
                bulges[k] = -4.0 * std::min(kDeepestBulge, 0.5 * edge.norm() / margin);
                kinds_[f] = Kind::Bulging;
            }
        }
        if (kinds_[f] == Kind::Bulging) {
            bulges_.emplace(static_cast<int>(f), bulges);
        }
    }
}

double Obstacles::closeness(const SurfacePoint& point) const {
    if (isAvoided(point.face)) {
        return 1.0;
    }
    const FaceCloseness face = onFace(point.face);
    double sum = 0.0;
    for (int k = 0; k < 3; ++k) {
        sum += point.barycentric[k] * face.corners[k] +
               face.bulges[k] * point.barycentric[(k + 1) % 3] * point.barycentric[(k + 2) % 3];
    }
    return sum;
}

SurfacePoint Obstacles::keptClear(const SurfacePoint& point, int opposite) const {
    if (isFar(point.face)) {
        return point;
    }
    // Positions on the edge, 0 at one end and 1 at the other.
    const int from = (opposite + 1) % 3;
    const int to = (opposite + 2) % 3;
    const auto pointAt = [&](double s) {
        SurfacePoint moved = point;
        moved.barycentric[from] = 1.0 - s;
        moved.barycentric[to] = s;
        return moved;
    };
    const auto clearanceAt = [&](double s) { return 1.0 - closeness(pointAt(s)); };
    const double here = point.barycentric[to];
    // J is convex along the edge: it is least at an end, or in the middle of a bulge.
    double best = 0.5;
    for (const double s : {0.0, 1.0}) {
        if (clearanceAt(s) > clearanceAt(best)) {
            best = s;
        }
    }
    const double wanted = kKeptShare * clearanceAt(best);
    if (clearanceAt(here) >= wanted) {
        return point;
    }
    double outside = here;
    double inside = best;
    for (int step = 0; step < 20; ++step) {
        const double middle = 0.5 * (outside + inside);
        (clearanceAt(middle) >= wanted ? inside : outside) = middle;
    }
    return pointAt(inside);
}

double Obstacles::pathCost(int face) const {
    if (isAvoided(face)) {
        return std::numeric_limits<double>::infinity();
    }
    if (isFar(face)) {
        return 1.0;
    }
    double sum = 0.0;
    for (int k = 0; k < 3; ++k) {
        Vec3 middle = Vec3::Constant(0.5);
        middle[k] = 0.0;
        sum += closeness({face, middle}) / 3.0;
    }
    // A face with one free edge has a mean below 1 all the same.
    return 1.0 + sum / (1.0 - std::min(sum, 1.0 - 1e-9));
}

Obstacles::FaceCloseness Obstacles::onFace(int face) const {
    FaceCloseness result;
    const Triangle& corners = extended_.faces[face];
    for (std::size_t k = 0; k < 3; ++k) {
        result.corners[k] = values_[corners[k]];
    }
    result.isBulging = kindOf(face) == Kind::Bulging;
    if (result.isBulging) {
        result.bulges = bulgesOf(face);
    }
    return result;
}

}  // namespace bspline_curve
