// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/shell_cell.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace bspline_curve {

ShellCell::ShellCell(const Shell& shell, int tetrahedron)
    : tet(tetrahedron), prism(tetrahedron / kTetrahedraPerPrism) {
    const std::array<Vec3, 4> v = {
        shell.position(tet, 0),
        shell.position(tet, 1),
        shell.position(tet, 2),
        shell.position(tet, 3)
    };
    const Vec3 e1 = v[1] - v[0];
    const Vec3 e2 = v[2] - v[0];
    const Vec3 e3 = v[3] - v[0];
    const Vec3 n1 = e2.cross(e3);
    const Vec3 n2 = e3.cross(e1);
    const Vec3 n3 = e1.cross(e2);
    const double inverseVolume = 1.0 / e1.dot(n1);
    gradients[1] = inverseVolume * n1;
    gradients[2] = inverseVolume * n2;
    gradients[3] = inverseVolume * n3;
    gradients[0] = -(gradients[1] + gradients[2] + gradients[3]);
    for (std::size_t k = 1; k < 4; ++k) {
        offsets[k] = -gradients[k].dot(v[0]);
    }
    offsets[0] = 1.0 - offsets[1] - offsets[2] - offsets[3];

    const Prism& p = shell.prisms()[static_cast<std::size_t>(prism)];
    const int inPrism = tet % kTetrahedraPerPrism;
    const double side = inPrism < 3 ? 1.0 : -1.0;
    heightGradient.setZero();
    for (std::size_t corner = 0; corner < 3; ++corner) {
        shadowGradients[corner].setZero();
    }
    for (std::size_t k = 0; k < 4; ++k) {
        const SplitVertex vertex = kSlabSplit[static_cast<std::size_t>(inPrism % 3)][k];
        const auto corner =
            static_cast<std::size_t>(p.faceCorner[static_cast<std::size_t>(vertex.slot)]);
        shadowGradients[corner] += gradients[k];
        shadowOffsets[corner] += offsets[k];
        if (vertex.outer) {
            heightGradient += side * gradients[k];
            heightOffset += side * offsets[k];
        }
    }
}

double ShellCell::insideness(const Vec3& p) const {
    double smallest = gradients[0].dot(p) + offsets[0];
    for (std::size_t k = 1; k < 4; ++k) {
        smallest = std::min(smallest, gradients[k].dot(p) + offsets[k]);
    }
    return smallest;
}

Vec3 fibreAt(const Shell& shell, int prism, const Vec3& shadow) {
    const Prism& p = shell.prisms()[static_cast<std::size_t>(prism)];
    Vec3 direction = Vec3::Zero();
    for (std::size_t slot = 0; slot < 3; ++slot) {
        const Pillar& pillar = shell.pillars()[static_cast<std::size_t>(p.pillars[slot])];
        direction += shadow[p.faceCorner[slot]] * (pillar.top - pillar.bottom);
    }
    return direction;
}

}  // namespace bspline_curve
