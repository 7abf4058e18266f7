// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/surface.h"

#include <span>
#include <vector>

namespace bspline_curve {

/// A barycentric coordinate at most this is zero: the point lies on the edge, or with two of them
/// on the vertex.
inline constexpr double kOnEdgeBarycentric = 1e-12;

/// Vertices of polylines that are nearer to an edge or a vertex than this are put on it.
inline constexpr double kSnapBarycentric = 1e-9;

/// All faces that hold a point: its own, the neighbour where it lies on an edge, the whole star
/// where it lies on a vertex. Ascending.
[[nodiscard]] std::vector<int> facesHolding(const Surface& surface, const SurfacePoint& point);

/// The same point in another of the faces that hold it.
[[nodiscard]] SurfacePoint inFace(const Surface& surface, const SurfacePoint& point, int face);

/// A face that holds both points, or -1. O(1), but where both are vertices.
[[nodiscard]] int commonFace(const Surface& surface, const SurfacePoint& a, const SurfacePoint& b);

/// The point with coordinates up to `tolerance` set to zero, so that it lies exactly on the edge or
/// the vertex that it is near.
[[nodiscard]] SurfacePoint snapped(const SurfacePoint& point, double tolerance);

/// Index (0, 1, 2) of a vertex in a face, or -1.
[[nodiscard]] inline int cornerOf(const Triangle& face, int vertex) {
    return face[0] == vertex ? 0 : (face[1] == vertex ? 1 : (face[2] == vertex ? 2 : -1));
}

}  // namespace bspline_curve
