// SPDX-License-Identifier: GPL-3.0-or-later
// Built with TetGen conforming_grid.cpp, without it conforming_grid_without_tetgen.cpp.
#pragma once

#include "bspline_curve/progress.h"
#include "io/tetrahedral_grid.h"
#include "shell/extended_surface.h"
#include "shell/shell.h"
#include "surface/surface.h"

#include <span>

namespace bspline_curve::cli {

/// Whether the program was built with TetGen.
[[nodiscard]] bool hasTetgen();

/// conformToSurface() as a grid for files. Not without TetGen.
[[nodiscard]] TetrahedralGrid conformingGrid(
    const Surface& surface,
    const ExtendedSurface& extended,
    const Shell& shell,
    std::span<const int> blockedFaces,
    const Progress& progress
);

}  // namespace bspline_curve::cli
