// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/shell.h"

#include <array>
#include <string>
#include <vector>

namespace bspline_curve {

/// A shell as a plain conforming tetrahedral mesh, for files. Blocked prisms and pillars without a
/// prism are left out.
struct ShellCells {
    std::vector<Vec3> points;  ///< user's unit; bottom, middle and top of a pillar, in turn
    /// Positively oriented (as VTK and Gmsh want), six per prism: three of the top slab, then three
    /// of the bottom.
    std::vector<std::array<int, 4>> tetrahedra;
    /// Three per prism, counter-clockwise seen from outside: top, middle, bottom.
    std::vector<Triangle> layers;
    std::vector<int> prisms;  ///< index of each prism in the shell
    std::vector<char> ghost;  ///< per prism: 1 where the surface has no face

    [[nodiscard]] int tetrahedronCount() const { return static_cast<int>(tetrahedra.size()); }

    /// f of a point: -1, 0 or 1.
    [[nodiscard]] static int height(int point) { return point % 3 - 1; }

    /// Position of a tetrahedron's prism in `prisms`.
    [[nodiscard]] static std::size_t prismOf(int tet) {
        return static_cast<std::size_t>(tet / kTetrahedraPerPrism);
    }

    /// 0: top, 1: bottom.
    [[nodiscard]] static int slabOf(int tet) { return tet % kTetrahedraPerPrism / 3; }
};

[[nodiscard]] ShellCells makeShellCells(const Shell& shell, const ShellFrame& frame);

/// Whether a prism lies beyond a boundary, where the surface has no face.
[[nodiscard]] bool isGhostPrism(const Shell& shell, int prism);

/// Top, middle and bottom as triangles; see shellBytes().
[[nodiscard]] std::string plyBytes(const ShellCells& cells);

}  // namespace bspline_curve
