// SPDX-License-Identifier: GPL-3.0-or-later
#include "field/normal_variation.h"

#include "surface/vertex_normals.h"

#include <algorithm>
#include <cstddef>

namespace bspline_curve {

std::vector<double> normalVariation(const Surface& surface) {
    const std::vector<Vec3> normals = vertexNormals(surface.mesh());
    std::vector<double> values(normals.size(), 1.0);
    for (int face = 0; face < surface.faceCount(); ++face) {
        const Vec3 normal = surface.faceNormal(face);
        for (const int corner : surface.faces()[face]) {
            const auto at = static_cast<std::size_t>(corner);
            values[at] = std::min(values[at], std::max(-1.0, normals[at].dot(normal)));
        }
    }
    return values;
}

}  // namespace bspline_curve
