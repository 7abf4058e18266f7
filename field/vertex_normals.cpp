// SPDX-License-Identifier: GPL-3.0-or-later
#include "field/vertex_normals.h"

#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>

namespace bspline_curve {

std::vector<Vec3> vertexNormals(const Surface& surface) {
    std::vector<Vec3> normals(surface.vertices().size(), Vec3::Zero());
    for (const Triangle& face : surface.faces()) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto at = static_cast<std::size_t>(face[k]);
            const Vec3& corner = surface.vertices()[at];
            const Vec3 next = surface.vertices()[face[(k + 1) % 3]] - corner;
            const Vec3 previous = surface.vertices()[face[(k + 2) % 3]] - corner;
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
