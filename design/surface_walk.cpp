// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/surface_walk.h"

#include "projection/curve_trace.h"
#include "surface/surface_point.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <limits>

namespace bspline_curve {
namespace {

struct WalkConstants {
    double sameShare = 0.3;  // of the way: points nearer to each other are one
    int shortSteps = 8;      // that are walked in, where one step does not lead over it
    // Of the height of a face beside the boundary: nodes keep no farther away.
    double mostShare = 1.0 / 3.0;
    // Times the clearance: what has been put there counts as too near still.
    double rounding = 1.0 + 1e-9;
};

constexpr WalkConstants kWalk;

}  // namespace

bool areJoined(
    const ExtendedSurface& extended,
    const FibreProjector& finder,
    const SurfaceNode& from,
    const SurfaceNode& to
) {
    const Vec3 way = to.position - from.position;
    return std::ranges::any_of(std::array{1, kWalk.shortSteps}, [&](int steps) {
        FootPoint foot = from.foot;
        FootFrame frame = from.frame;
        for (int i = 1; i <= steps; ++i) {
            const double share = static_cast<double>(i) / steps;
            finder.move(from.position + share * way, foot, frame);
        }
        const Vec3 end = extended.position({foot.face, foot.barycentric()});
        return (end - to.position).norm() <= kWalk.sameShare * way.norm() &&
               frame.direction.dot(to.frame.direction) > 0.0;
    });
}

// Whether a neighbour is beyond the boundary: a face of the extension, or none in narrow notches.
bool BoundaryGuard::isBeyond(int face) const {
    return face < 0 || face >= extended_.surfaceFaceCount;
}

bool BoundaryGuard::isBeside(int face) const {
    return std::ranges::any_of(extended_.faceNeighbours[face], [&](int neighbour) {
        return isBeyond(neighbour);
    });
}

// The side on the boundary that is nearest, of its face.
BoundaryGuard::Side BoundaryGuard::sideOf(const SurfaceNode& node) const {
    const Triangle& face = extended_.faces[node.foot.face];
    const Vec3 share = node.foot.barycentric();
    const auto corner = [&](int k) -> const Vec3& { return extended_.vertices[face[k % 3]]; };
    Side nearest;
    for (int k = 0; k < 3; ++k) {
        if (!isBeyond(extended_.faceNeighbours[node.foot.face][k])) {
            continue;
        }
        const Vec3 side = corner(k + 2) - corner(k + 1);
        const double height = side.cross(corner(k) - corner(k + 1)).norm() / side.norm();
        if (nearest.corner < 0 || share[k] * height < nearest.share * nearest.height) {
            nearest = {k, height, share[k]};
        }
    }
    return nearest;
}

double BoundaryGuard::distanceOf(const SurfaceNode& node) const {
    const Side side = sideOf(node);
    return side.corner < 0 ? std::numeric_limits<double>::infinity() : side.share * side.height;
}

bool BoundaryGuard::isOnBoundary(int face, int corner) const {
    const int vertex = extended_.faces[face][corner];
    int at = face;
    int k = corner;
    do {
        at = extended_.faceNeighbours[at][(k + 1) % 3];
        if (isBeyond(at)) {
            return true;
        }
        k = cornerOf(extended_.faces[at], vertex);
    } while (at != face);
    return false;
}

bool BoundaryGuard::isNear(const SurfaceNode& node, double clearance) const {
    const Triangle& face = extended_.faces[node.foot.face];
    const auto isNearCorner = [&](int k) {
        return (node.position - extended_.vertices[face[k]]).norm() <= clearance &&
               isOnBoundary(node.foot.face, k);
    };
    return distanceOf(node) <= clearance || isNearCorner(0) || isNearCorner(1) || isNearCorner(2);
}

Vec3 BoundaryGuard::inwardsAt(const SurfaceNode& node, double clearance) const {
    const auto [k, height, share] = sideOf(node);
    if (k < 0 || share * height > kWalk.rounding * std::min(clearance, kWalk.mostShare * height)) {
        return Vec3::Zero();
    }
    const Triangle& face = extended_.faces[node.foot.face];
    const Vec3& start = extended_.vertices[face[(k + 1) % 3]];
    const Vec3 side = extended_.vertices[face[(k + 2) % 3]] - start;
    return side.cross(extended_.vertices[face[k]] - start).cross(side).normalized();
}

void BoundaryGuard::putBack(SurfaceNode& node, double clearance) const {
    const SurfacePoint on = onSurface(extended_, node.foot.face, node.foot.barycentric());
    node.foot = FootPoint::at(on);
    const auto [k, height, share] = sideOf(node);
    const double least = k < 0 ? 0.0 : std::min(kWalk.mostShare, clearance / height);
    if (share < least) {
        Vec3 inside = (1.0 - least) / (1.0 - share) * on.barycentric;
        inside[k] = least;
        node.foot = FootPoint::at({on.face, inside});
    }
    node.position = extended_.position({node.foot.face, node.foot.barycentric()});
    FootPoint foot = node.foot;
    finder_.move(node.position, foot, node.frame);
}

}  // namespace bspline_curve
