// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/progress.h"
#include "surface/surface.h"

#include <Eigen/Core>

#include <vector>

namespace bspline_curve {

/// Symmetric matrices at the vertices, #V: largest curvature times (d d^T) of the direction d of
/// the smallest, plus smallest curvature times (d d^T) of the direction of the largest, in 1 / unit
/// of the surface, positive where the surface is convex seen from outside. Directions change places
/// so that a crease has nearly the same matrix on both of its sides: its own direction.
/// Each is that of a quadric through a vertex, the nearest by least squares to `rings` (1 or 2)
/// rings of vertices around it whose normals are on its side; always 2 where less than five faces
/// meet. The second does not go on from the hubs of large fans, so that the time is proportional to
/// their valence. Zero where less than five vertices are found. About 1 us per vertex, on two
/// threads where there are many.
[[nodiscard]] std::vector<Eigen::Matrix3d> curvatureTensors(
    const Surface& surface,
    const std::vector<Vec3>& normals,
    int rings,
    const Progress& progress = {}
);

}  // namespace bspline_curve
