// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/surface.h"

#include <Eigen/Core>

#include <vector>

namespace bspline_curve {

/// A part of the surroundings of a point: what one side of one face subtends.
struct FanWedge {
    using Vec2 = Eigen::Vector2d;

    int face = -1;
    int exit = 0;                                    ///< the side opposite to this corner
    Vec2 source = Vec2::Zero();                      ///< the point, in FaceLayout with frame 0
    Vec2 first = Vec2::Zero(), last = Vec2::Zero();  ///< unit directions, counter-clockwise
    double start = 0.0, width = 0.0;                 ///< angles
};

/// All directions at a point of a surface, by their angles: counter-clockwise from an arbitrary
/// one. At a vertex the angles of its faces add up to what they are, not to a full turn.
struct SurfaceFan {
    std::vector<FanWedge> wedges;  ///< counter-clockwise
    double angle = 0.0;            ///< of all
    bool closed = true;            ///< false: the surface's boundary lies between last and first
};

[[nodiscard]] SurfaceFan fanOfVertex(const Surface& surface, int vertex);

/// Of any point; one with a barycentric coordinate up to kOnEdgeBarycentric is on the edge or the
/// vertex.
[[nodiscard]] SurfaceFan fanOf(const Surface& surface, const SurfacePoint& point);

/// The angle in the fan of `from` at which another point lies that shares a face with it.
[[nodiscard]] double angleTowards(
    const Surface& surface, const SurfaceFan& fan, const SurfacePoint& from, const SurfacePoint& to
);

}  // namespace bspline_curve
