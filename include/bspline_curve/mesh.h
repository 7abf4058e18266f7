// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <array>
#include <vector>

namespace bspline_curve {

using Vec3 = Eigen::Vector3d;
using Triangle = std::array<int, 3>;

/// A triangle mesh as plain arrays, before validation. Coordinates in the user's unit,
/// faces as counter-clockwise vertex indices.
struct TriangleMesh {
    std::vector<Vec3> vertices;
    std::vector<Triangle> faces;
};

/// A point of a surface: a face and barycentric coordinates in it. The coordinates are in the order
/// of the face's vertices, each in [0, 1], and sum to 1.
struct SurfacePoint {
    int face = -1;
    Vec3 barycentric = Vec3::Zero();
};

}  // namespace bspline_curve
