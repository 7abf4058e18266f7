// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

#include <array>
#include <cstddef>

namespace bspline_curve {

/// A symmetric 3 by 3 matrix: xx, xy, xz, yy, yz, zz.
using SymmetricMatrix = std::array<double, 6>;

[[nodiscard]] inline SymmetricMatrix operator*(double scale, const SymmetricMatrix& m) {
    return {scale * m[0], scale * m[1], scale * m[2], scale * m[3], scale * m[4], scale * m[5]};
}

inline SymmetricMatrix& operator+=(SymmetricMatrix& sum, const SymmetricMatrix& m) {
    for (std::size_t e = 0; e < sum.size(); ++e) {
        sum[e] += m[e];
    }
    return sum;
}

/// scale v v^T.
[[nodiscard]] inline SymmetricMatrix rankOne(const Vec3& v, double scale) {
    const Vec3 u = scale * v;
    return {u[0] * v[0], u[0] * v[1], u[0] * v[2], u[1] * v[1], u[1] * v[2], u[2] * v[2]};
}

}  // namespace bspline_curve
