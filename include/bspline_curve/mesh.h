// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <span>
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

/// The position of a point of a mesh.
[[nodiscard]] inline Vec3 positionOf(const TriangleMesh& mesh, const SurfacePoint& point) {
    const Triangle& face = mesh.faces[point.face];
    return point.barycentric[0] * mesh.vertices[face[0]] +
           point.barycentric[1] * mesh.vertices[face[1]] +
           point.barycentric[2] * mesh.vertices[face[2]];
}

/// A value at a point of a mesh with these faces, linear in each, from those at its vertices.
[[nodiscard]] inline double valueAt(
    const std::vector<Triangle>& faces, std::span<const double> values, const SurfacePoint& point
) {
    double value = 0.0;
    for (int k = 0; k < 3; ++k) {
        value += point.barycentric[k] * values[faces[point.face][k]];
    }
    return value;
}

/// A region of a mesh: ids of its faces, ascending, each once.
using Region = std::vector<int>;

/// The region of faces given by id, in any order. Throws InputError (IndexOutOfRange) naming the
/// ids that are no face of the mesh.
[[nodiscard]] Region makeRegion(const TriangleMesh& mesh, std::span<const std::int64_t> faces);

/// The faces all of whose corners are selected; one flag per vertex. Throws InputError
/// (IndexOutOfRange) where there are more or fewer flags.
[[nodiscard]] Region facesOfVertices(const TriangleMesh& mesh, std::span<const char> selected);

/// The faces over whose corners the mean of a field, one value per vertex, is under (over) a
/// threshold. Throws InputError: BadField (other than one value per vertex), BadOption (a threshold
/// that is no number).
[[nodiscard]] Region facesUnder(
    const TriangleMesh& mesh, std::span<const double> field, double threshold
);
[[nodiscard]] Region facesOver(
    const TriangleMesh& mesh, std::span<const double> field, double threshold
);

/// One flag per face: 1 in the region.
[[nodiscard]] std::vector<char> faceFlags(const TriangleMesh& mesh, const Region& region);

}  // namespace bspline_curve
