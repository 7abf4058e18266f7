// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/vertex_normals.h"

#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>

namespace bspline_curve {

namespace {

/// For each vertex the sum of its faces' normals, weighted by angles, and of these angles.
struct NormalSums {
    std::vector<Vec3> normals;
    std::vector<double> angles;
};

NormalSums normalSums(const TriangleMesh& mesh) {
    NormalSums sums{
        .normals = std::vector<Vec3>(mesh.vertices.size(), Vec3::Zero()),
        .angles = std::vector<double>(mesh.vertices.size(), 0.0)
    };
    for (const Triangle& face : mesh.faces) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto at = static_cast<std::size_t>(face[k]);
            const Vec3& corner = mesh.vertices[at];
            const Vec3 next = mesh.vertices[face[(k + 1) % 3]] - corner;
            const Vec3 previous = mesh.vertices[face[(k + 2) % 3]] - corner;
            const Vec3 doubleArea = next.cross(previous);
            const double length = doubleArea.norm();
            const double angle = std::atan2(length, next.dot(previous));
            sums.normals[at] += doubleArea / length * angle;
            sums.angles[at] += angle;
        }
    }
    return sums;
}

}  // namespace

std::vector<Vec3> vertexNormals(const TriangleMesh& mesh) {
    std::vector<Vec3> normals = normalSums(mesh).normals;
    for (Vec3& normal : normals) {
        normal.normalize();
    }
    return normals;
}

std::vector<Vec3> meanNormals(const TriangleMesh& mesh) {
    auto [normals, angles] = normalSums(mesh);
    for (std::size_t v = 0; v < normals.size(); ++v) {
        if (angles[v] > 0.0) {
            normals[v] /= angles[v];
        }
    }
    return normals;
}

}  // namespace bspline_curve
