// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/shell.h"

#include <ostream>
#include <span>

namespace bspline_curve::test_support {

/// What TetGen says about a shell: a proof of its layers that shares nothing with ours.
struct TetgenProof {
    int intersectingFaces = 0;  ///< of top, surface, bottom and end walls; its switch -d
    int error = 0;              ///< that the tetrahedralisation stopped with
    int tetrahedra = 0;
    /// Volume of the tetrahedralisation by what the shell encloses, cavities included.
    double volumeRatio = 0.0;

    /// Nothing intersects, and the faces have a constrained tetrahedralisation that fills the
    /// shell.
    [[nodiscard]] bool holds() const;
};

std::ostream& operator<<(std::ostream& stream, const TetgenProof& proof);

/// The shortest edge of top, surface, bottom and end walls, in the shell's frame.
[[nodiscard]] double shortestTetgenEdge(
    const Shell& shell, const ExtendedSurface& extended, std::span<const int> blockedFaces
);

/// Tetrahedralises top, surface (the faces that are not blocked, without ghosts), bottom and the
/// walls where the shell ends, which TetGen can do only if they meet in common corners and edges
/// alone. Not in two threads at once.
[[nodiscard]] TetgenProof proveWithTetgen(
    const Shell& shell, const ExtendedSurface& extended, std::span<const int> blockedFaces
);

}  // namespace bspline_curve::test_support
