// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/shell.h"
#include "shell/shell_base.h"
#include "surface/surface.h"

#include <vector>

namespace bspline_curve {

/// Half a prism at least where a curve is traced or cast onto the surface, in tolerances of its
/// distance.
inline constexpr double kLeastNearTolerances = 2.5;

/// How far a near shell reaches.
struct NearShellSize {
    int rings = 2;  ///< of faces about those given; faces that share a vertex are neighbours
    double thickness = 0.5;  ///< half a prism, in mean lengths of the edges at each vertex
    double least = 0.0;      ///< half a prism at least, in the shell's frame
};

/// Prisms of full resolution over some faces of a surface, those near a curve. Where nothing is in
/// their way they are those of the whole shell. Prisms whose tetrahedra are not all positive
/// (exact) shrink, and are left out where that does not help. Prisms over faces that are no
/// neighbours may overlap: they are only walked through from neighbour to neighbour.
struct NearShell {
    /// Over the faces given (in any order; of the whole base, ghosts included) and rings about
    /// them. O(n log n) for n faces there, about 0.6 us each.
    NearShell(
        const Surface& surface,
        const ShellBase& whole,
        const std::vector<int>& given,
        const NearShellSize& size
    );

    /// Where a face of the whole base is; -1 where it is not.
    [[nodiscard]] int indexOf(int face) const;

    /// A point of the surface with its face as it is called here. The face must be here.
    [[nodiscard]] SurfacePoint here(const SurfacePoint& point) const {
        return {indexOf(point.face), point.barycentric};
    }

    ShellBase base;          ///< these faces alone, ghosts last
    std::vector<int> faces;  ///< face of the whole base for each face, ascending
    Shell shell = Shell({}, {}, 0);
};

}  // namespace bspline_curve
