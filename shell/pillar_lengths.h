// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/progress.h"
#include "shell/extended_surface.h"

#include <array>
#include <vector>

namespace bspline_curve {

/// Shortens half pillars that would reach a face of another part of the surface, to less than half
/// of the way there, so that the shells of two close sheets start apart. `lengths` are those above
/// (0) and below (1) each vertex. Faces between the pillars of a coarser sheet are not seen; what
/// overlaps there is for the tests of the builder to find. O(n log n). Throws Cancelled.
void limitPillarLengths(
    const ExtendedSurface& extended,
    std::array<std::vector<double>, 2>& lengths,
    const Progress& progress = {}
);

}  // namespace bspline_curve
