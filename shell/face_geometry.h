// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/extended_surface.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <optional>

namespace bspline_curve {

[[nodiscard]] inline std::array<Vec3, 3> cornersOf(const ExtendedSurface& extended, int face) {
    const auto& [a, b, c] = extended.faces[face];
    return {extended.vertices[a], extended.vertices[b], extended.vertices[c]};
}

/// The normal of a face, as long as twice its area.
[[nodiscard]] inline Vec3 areaNormal(const ExtendedSurface& extended, int face) {
    const auto& [a, b, c] = extended.faces[face];
    const Vec3& first = extended.vertices[a];
    return (extended.vertices[b] - first).cross(extended.vertices[c] - first);
}

/// Where the line p + t d passes a triangle: t, or nothing where it misses the triangle or is
/// parallel to it. A line that passes beside an edge, up to `margin` in barycentric coordinates,
/// counts.
[[nodiscard]] inline std::optional<double> intersectLine(
    const Vec3& p, const Vec3& d, const std::array<Vec3, 3>& triangle, double margin
) {
    const Vec3 e1 = triangle[1] - triangle[0];
    const Vec3 e2 = triangle[2] - triangle[0];
    const Vec3 normal = e1.cross(e2);
    const double slope = normal.dot(d);
    if (slope == 0.0) {
        return std::nullopt;
    }
    const Vec3 turn = d.cross(triangle[0] - p) / slope;
    const double u = -e2.dot(turn);
    const double v = e1.dot(turn);
    if (std::min({u, v, 1.0 - u - v}) < -margin) {
        return std::nullopt;
    }
    return normal.dot(triangle[0] - p) / slope;
}

}  // namespace bspline_curve
