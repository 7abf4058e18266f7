// SPDX-License-Identifier: GPL-3.0-or-later
#include "design/surface_walk.h"

#include "projection/curve_trace.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>

namespace bspline_curve {
namespace {

struct WalkConstants {
    double sameShare = 0.3;  // of the way: points nearer to each other are one
    int shortSteps = 8;      // that are walked in, where one step does not lead over it
    // Of the way from the boundary to the middle of a face: where a node is put back, and up to
    // where it counts as at the boundary.
    double inside = 1e-3;
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

bool isBeyondBoundary(const ExtendedSurface& extended, const SurfaceNode& node) {
    return node.foot.face >= extended.surfaceFaceCount;
}

void putBack(const ExtendedSurface& extended, const FibreProjector& finder, SurfaceNode& node) {
    SurfacePoint point = onSurface(extended, node.foot.face, node.foot.barycentric());
    point.barycentric += kWalk.inside * (Vec3::Constant(1.0 / 3.0) - point.barycentric);
    node.foot = FootPoint::at(point);
    node.position = extended.position(point);
    FootPoint foot = node.foot;
    finder.move(node.position, foot, node.frame);
}

Vec3 inwardsAtBoundary(const ExtendedSurface& extended, const SurfaceNode& node) {
    const Triangle& face = extended.faces[node.foot.face];
    const Vec3 share = node.foot.barycentric();
    const auto cornerAt = [&](int k) -> const Vec3& { return extended.vertices[face[k % 3]]; };
    for (int k = 0; k < 3; ++k) {
        const int across = extended.faceNeighbours[node.foot.face][k];
        if (share[k] <= kWalk.inside && across >= extended.surfaceFaceCount) {
            const Vec3 side = cornerAt(k + 2) - cornerAt(k + 1);
            return side.cross(cornerAt(k) - cornerAt(k + 1)).cross(side);
        }
    }
    return Vec3::Zero();
}

}  // namespace bspline_curve
