// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/vertex_normals.h"

#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>

namespace bspline_curve {

std::vector<Vec3> vertexNormals(const TriangleMesh& mesh) {
    std::vector<Vec3> normals(mesh.vertices.size(), Vec3::Zero());
    for (const Triangle& face : mesh.faces) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto at = static_cast<std::size_t>(face[k]);
            const Vec3& corner = mesh.vertices[at];
            const Vec3 next = mesh.vertices[face[(k + 1) % 3]] - corner;
            const Vec3 previous = mesh.vertices[face[(k + 2) % 3]] - corner;
            const Vec3 doubleArea = next.cross(previous);
            const double length = doubleArea.norm();
            normals[at] += doubleArea / length * std::atan2(length, next.dot(previous));
        }
    }
    for (Vec3& normal : normals) {
        normal.normalize();
    }
    return normals;
}

}  // namespace bspline_curve
