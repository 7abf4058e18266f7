// SPDX-License-Identifier: GPL-3.0-or-later
#include "tetrahedra/conforming_file.h"

#include "io/shell_writer.h"
#include "io/tetrahedral_grid.h"
#include "io/whole_shell_parts.h"
#include "tetrahedra/conforming_tetrahedra.h"

#include <cstdint>
#include <utility>

namespace bspline_curve {

std::string conformingFileBytes(
    const std::filesystem::path& file, const WholeShell& shell, const Progress& progress
) {
    const WholeShell::Parts& parts = shell.parts();
    ConformingTetrahedra made = conformToSurface(
        parts.surface, *parts.extended, parts.shell(), parts.blockedFaces(), progress
    );
    TetrahedralGrid grid{
        .points = std::move(made.points),
        .heights = std::move(made.heights),
        .tetrahedra = std::move(made.tetrahedra),
        .slabName = "side",
        .slabs = {},
        .fields = {}
    };
    for (const SurfaceSide side : made.sides) {
        grid.slabs.push_back(static_cast<std::uint8_t>(side));
    }
    return gridBytes(file, grid);
}

}  // namespace bspline_curve
