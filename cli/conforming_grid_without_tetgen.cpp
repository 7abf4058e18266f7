// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/conforming_grid.h"

#include <stdexcept>

namespace bspline_curve::cli {

bool hasTetgen() {
    return false;
}

TetrahedralGrid conformingGrid(
    const Surface& /*surface*/,
    const ExtendedSurface& /*extended*/,
    const Shell& /*shell*/,
    std::span<const int> /*blockedFaces*/,
    const Progress& /*progress*/
) {
    throw std::logic_error("conformingGrid() without TetGen");
}

}  // namespace bspline_curve::cli
