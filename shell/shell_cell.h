// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/shell.h"

namespace bspline_curve {

/// One tetrahedron of the shell with its affine maps: everything that a curve needs to know while
/// it is inside. All gradients are exact and constant in the cell. Built in about 30 ns, holds no
/// pointer.
struct ShellCell {
    int tet = -1;
    int prism = -1;

    /// Barycentric coordinate k of a point p of the tetrahedron is gradients[k] . p + offsets[k].
    std::array<Vec3, 4> gradients;
    std::array<double, 4> offsets{};

    /// f (10): the signed relative height w, in [-1, 1].
    Vec3 heightGradient;
    double heightOffset = 0.0;

    /// Barycentric coordinates of the shadow M_S(p), in the order of the face's vertices.
    std::array<Vec3, 3> shadowGradients;
    std::array<double, 3> shadowOffsets{};

    ShellCell() = default;
    ShellCell(const Shell& shell, int tet);

    [[nodiscard]] double height(const Vec3& p) const {
        return heightGradient.dot(p) + heightOffset;
    }

    /// Barycentric coordinates of the shadow in its face (ghost prisms: in the ghost triangle).
    [[nodiscard]] Vec3 shadow(const Vec3& p) const {
        return {
            shadowGradients[0].dot(p) + shadowOffsets[0],
            shadowGradients[1].dot(p) + shadowOffsets[1],
            shadowGradients[2].dot(p) + shadowOffsets[2]
        };
    }

    /// Smallest barycentric coordinate: >= 0 where the cell holds p.
    [[nodiscard]] double insideness(const Vec3& p) const;
};

/// The fibre direction at a shadow: bottom to top, interpolated between the pillars, not
/// normalised.
[[nodiscard]] Vec3 fibreAt(const Shell& shell, int prism, const Vec3& shadow);

}  // namespace bspline_curve
