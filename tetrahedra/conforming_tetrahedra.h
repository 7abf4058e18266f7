// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/progress.h"
#include "shell/extended_surface.h"
#include "shell/shell.h"
#include "surface/surface.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace bspline_curve {

/// Which side of the surface a tetrahedron is on, seen along its normals. Beyond a boundary, where
/// nothing parts the sides, that of the nearest face, top or bottom, counted in tetrahedra.
enum class SurfaceSide : std::uint8_t { Above, Below };

/// The space of a shell in tetrahedra that conform to the surface: its faces are faces of them.
struct ConformingTetrahedra {
    /// User's unit: the vertices of the surface, in their order, then those of the shell's
    /// boundary, then those that TetGen added.
    std::vector<Vec3> points;
    std::vector<double> heights;                 ///< f of the shell at each point, in [-1, 1]
    std::vector<std::array<int, 4>> tetrahedra;  ///< positively oriented
    std::vector<SurfaceSide> sides;              ///< of each tetrahedron
};

/// TetGen's constrained tetrahedralisation of the boundary of a simplified shell and the surface
/// (H. Si, TetGen, ACM Trans. Math. Softw. 41(2), 2015), neither of which it divides; its cavities
/// are left out. Faces without a prism are left out as well. Vertices that the shell moved
/// (ExtendedSurface::movedVertices) stand where the shell has them. About 30 us per face. Throws
/// InputError (NoShell) where TetGen refuses, saying why and what to do; Cancelled between steps.
[[nodiscard]] ConformingTetrahedra conformToSurface(
    const Surface& surface,
    const ExtendedSurface& extended,
    const Shell& shell,
    std::span<const int> blockedFaces,
    const Progress& progress = {}
);

}  // namespace bspline_curve
