// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/conforming_grid.h"

#include "tetrahedra/conforming_tetrahedra.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <utility>

namespace bspline_curve::cli {

bool hasTetgen() {
    return true;
}

TetrahedralGrid conformingGrid(
    const Surface& surface,
    const ExtendedSurface& extended,
    const Shell& shell,
    std::span<const int> blockedFaces,
    const Progress& progress
) {
    ConformingTetrahedra made = conformToSurface(surface, extended, shell, blockedFaces, progress);
    TetrahedralGrid grid{
        .points = std::move(made.points),
        .heights = std::move(made.heights),
        .tetrahedra = std::move(made.tetrahedra),
        .slabName = "side",
        .slabs = {},
        .fields = {}
    };
    std::ranges::transform(made.sides, std::back_inserter(grid.slabs), [](SurfaceSide side) {
        return static_cast<std::uint8_t>(side);
    });
    return grid;
}

}  // namespace bspline_curve::cli
