// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

#include <array>

namespace bspline_curve {

/// Whether a triangle passes through the inside of a tetrahedron, or lies in the plane of one of
/// its faces and passes through the inside of that. Touching edges, or faces in points and lines
/// alone, is no overlap. Triangles without area stand for the segments or points that they are.
/// False for a flat tetrahedron. Exact. About 0.1 us where a corner decides, 1 us otherwise.
[[nodiscard]] bool overlaps(
    const std::array<Vec3, 4>& tetrahedron, const std::array<Vec3, 3>& triangle
);

/// Sign of the dot product of a triangle's normal, (b - a) x (c - a), with `to` - `from`. Exact,
/// unless a product of three differences, or of their rounding errors, underflows.
[[nodiscard]] int normalDotSign(
    const std::array<Vec3, 3>& triangle, const Vec3& from, const Vec3& to
);

}  // namespace bspline_curve
