// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

#include <cmath>

namespace bspline_curve {

// Exact orientation predicates. The sign comes from plain floating point where Shewchuk's error
// bound proves it, else from the determinant as an exact sum of doubles (J. R. Shewchuk, Adaptive
// Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates, 1997, Sect. 2 and 4).
//
// Exact means: for the coordinates as stored, unless a product of three differences overflows or
// underflows; nonzero differences between 2^-142 and 2^201 in size are always safe.

namespace detail {

inline constexpr double kHalfUlp = 0x1p-53;
/// Error bounds A of orient3d and orient2d, relative to the permanent of the determinant.
inline constexpr double kOrient3dBound = (7.0 + 56.0 * kHalfUlp) * kHalfUlp;
inline constexpr double kOrient2dBound = (3.0 + 16.0 * kHalfUlp) * kHalfUlp;

[[nodiscard]] int exactOrientationSign(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
[[nodiscard]] int exactProjectedOrientationSign(
    const Vec3& a, const Vec3& b, const Vec3& c, int droppedAxis
);

}  // namespace detail

/// Sign of the volume of the tetrahedron (a, b, c, d): +1 where d lies on the side of the plane
/// (a, b, c) from which a, b, c appear counter-clockwise [the side of (b-a) x (c-a)], -1 on the
/// other, 0 where the four are coplanar. Odd permutations of the points flip it, even ones do not.
/// Exact. About 5 ns where the points are far from coplanar.
[[nodiscard]] inline int orientationSign(
    const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d
) {
    const double bx = b[0] - a[0], by = b[1] - a[1], bz = b[2] - a[2];
    const double cx = c[0] - a[0], cy = c[1] - a[1], cz = c[2] - a[2];
    const double dx = d[0] - a[0], dy = d[1] - a[1], dz = d[2] - a[2];
    const double cxdy = cx * dy, dxcy = dx * cy;
    const double dxby = dx * by, bxdy = bx * dy;
    const double bxcy = bx * cy, cxby = cx * by;
    const double determinant = bz * (cxdy - dxcy) + cz * (dxby - bxdy) + dz * (bxcy - cxby);
    const double permanent = std::abs(bz) * (std::abs(cxdy) + std::abs(dxcy)) +
                             std::abs(cz) * (std::abs(dxby) + std::abs(bxdy)) +
                             std::abs(dz) * (std::abs(bxcy) + std::abs(cxby));
    const double bound = detail::kOrient3dBound * permanent;
    if (determinant > bound) {
        return 1;
    }
    if (determinant < -bound) {
        return -1;
    }
    return detail::exactOrientationSign(a, b, c, d);
}

/// Sign of the area of the triangle (a, b, c) projected along a coordinate axis: +1 where the
/// projection runs counter-clockwise in the plane of the other two coordinates (axis + 1, axis + 2,
/// cyclic), which is the sign of that component of (b-a) x (c-a); 0 where it is collinear. Exact.
[[nodiscard]] inline int projectedOrientationSign(
    const Vec3& a, const Vec3& b, const Vec3& c, int droppedAxis
) {
    const int x = (droppedAxis + 1) % 3;
    const int y = (droppedAxis + 2) % 3;
    const double left = (b[x] - a[x]) * (c[y] - a[y]);
    const double right = (b[y] - a[y]) * (c[x] - a[x]);
    const double determinant = left - right;
    const double bound = detail::kOrient2dBound * (std::abs(left) + std::abs(right));
    if (determinant > bound) {
        return 1;
    }
    if (determinant < -bound) {
        return -1;
    }
    return detail::exactProjectedOrientationSign(a, b, c, droppedAxis);
}

}  // namespace bspline_curve
