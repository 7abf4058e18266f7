// SPDX-License-Identifier: GPL-3.0-or-later
#include "offset/surface_fan.h"

#include "offset/face_layout.h"
#include "surface/surface_point.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bspline_curve {

namespace {

using Vec2 = Eigen::Vector2d;

void addWedge(SurfaceFan& fan, const Surface& surface, const SurfacePoint& at, int exit) {
    const FaceLayout layout(surface.vertices(), surface.faces()[at.face], 0);
    const Vec2 source = layout.position(at.barycentric);
    const Vec2 first = (layout.corners[(exit + 1) % 3] - source).normalized();
    const Vec2 last = (layout.corners[(exit + 2) % 3] - source).normalized();
    const double width = angleBetween(first, last);
    fan.wedges.push_back(
        {.face = at.face,
         .exit = exit,
         .source = source,
         .first = first,
         .last = last,
         .start = fan.angle,
         .width = width}
    );
    fan.angle += width;
}

}  // namespace

SurfaceFan fanOfVertex(const Surface& surface, int vertex) {
    SurfaceFan fan;
    fan.closed = !surface.isBoundaryVertex(vertex);
    for (const int f : surface.facesAround(vertex)) {
        const int corner = cornerOf(surface.faces()[f], vertex);
        addWedge(fan, surface, {.face = f, .barycentric = Vec3::Unit(corner)}, corner);
    }
    return fan;
}

SurfaceFan fanOf(const Surface& surface, const SurfacePoint& point) {
    const SurfacePoint at = snapped(point, kOnEdgeBarycentric);
    std::vector<int> zeros;
    for (int k = 0; k < 3; ++k) {
        if (at.barycentric[k] == 0.0) {
            zeros.push_back(k);
        }
    }
    if (zeros.size() == 2) {
        return fanOfVertex(surface, surface.faces()[at.face][3 - zeros[0] - zeros[1]]);
    }
    SurfaceFan fan;
    if (zeros.empty()) {
        for (int k = 0; k < 3; ++k) {
            addWedge(fan, surface, at, k);
        }
        return fan;
    }
    const int side = zeros.front();
    addWedge(fan, surface, at, (side + 1) % 3);
    addWedge(fan, surface, at, (side + 2) % 3);
    const int across = surface.faceNeighbours()[at.face][side];
    fan.closed = across >= 0;
    if (fan.closed) {
        const SurfacePoint there = inFace(surface, at, across);
        int thatSide = 0;
        there.barycentric.minCoeff(&thatSide);
        addWedge(fan, surface, there, (thatSide + 1) % 3);
        addWedge(fan, surface, there, (thatSide + 2) % 3);
    }
    return fan;
}

double angleTowards(
    const Surface& surface, const SurfaceFan& fan, const SurfacePoint& from, const SurfacePoint& to
) {
    const int face = commonFace(surface, from, to);
    const FaceLayout layout(surface.vertices(), surface.faces()[face], 0);
    const Vec2 target = layout.position(inFace(surface, to, face).barycentric);
    double best = std::numeric_limits<double>::infinity();
    double angle = 0.0;
    for (const FanWedge& wedge : fan.wedges) {
        if (wedge.face == face) {
            const double within = angleBetween(wedge.first, target - wedge.source);
            const double outside = std::max({-within, within - wedge.width, 0.0});
            if (outside < best) {
                best = outside;
                angle = wedge.start + std::clamp(within, 0.0, wedge.width);
            }
        }
    }
    return angle;
}

}  // namespace bspline_curve
