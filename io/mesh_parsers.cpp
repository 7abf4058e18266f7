// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/mesh_parsers.h"

#include "fill/rim_triangulation.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace bspline_curve {

namespace {

/// Whether a triangle of the fan at the first point has its normal against that of the polygon.
bool fanFolds(const std::vector<Vec3>& polygon) {
    std::vector<Vec3> normals;
    Vec3 sum = Vec3::Zero();
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
        const Vec3 a = polygon[k] - polygon[0];
        const Vec3 b = polygon[k + 1] - polygon[0];
        normals.emplace_back(a.cross(b));
        sum += normals.back();
    }
    return std::ranges::any_of(normals, [&](const Vec3& normal) { return normal.dot(sum) < 0.0; });
}

}  // namespace

void addPolygon(
    std::span<const int> corners, const std::vector<Vec3>& vertices, std::vector<Triangle>& faces
) {
    const auto isKnown = [&](int id) { return static_cast<std::size_t>(id) < vertices.size(); };
    if (corners.size() > 3 && std::ranges::all_of(corners, isKnown)) {
        std::vector<Vec3> polygon;
        for (const int id : corners) {
            polygon.push_back(vertices[id]);
        }
        if (fanFolds(polygon)) {
            // Empty where corners repeat or meet: the fan is as good then.
            const std::vector<Triangle> triangles = triangulateRim(polygon, {}, [] {});
            for (const auto& [a, b, c] : triangles) {
                faces.push_back({corners[a], corners[b], corners[c]});
            }
            if (!triangles.empty()) {
                return;
            }
        }
    }
    for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
        faces.push_back({corners[0], corners[k], corners[k + 1]});
    }
}

bool sortAndFindRepeated(std::span<int> corners) {
    std::ranges::sort(corners);
    return std::ranges::adjacent_find(corners) != corners.end();
}

}  // namespace bspline_curve
