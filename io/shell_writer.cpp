// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/shell_writer.h"

#include "bspline_curve/error.h"
#include "bspline_curve/whole_shell.h"
#include "io/shell_cells.h"
#include "io/tetrahedral_grid.h"
#include "text/text_parsing.h"

#include <cstddef>
#include <cstdint>
#include <utility>

namespace bspline_curve {

namespace {

TetrahedralGrid gridOf(ShellCells cells) {
    const int points = static_cast<int>(cells.points.size());
    const int tets = cells.tetrahedronCount();
    TetrahedralGrid grid{
        .points = std::move(cells.points),
        .heights = {},
        .tetrahedra = std::move(cells.tetrahedra),
        .slabName = "slab",
        .slabs = {},
        .fields = {{.name = "prism", .values = {}}, {.name = "ghost", .values = {}}}
    };
    for (int i = 0; i < points; ++i) {
        grid.heights.push_back(ShellCells::height(i));
    }
    for (int tet = 0; tet < tets; ++tet) {
        const std::size_t prism = ShellCells::prismOf(tet);
        grid.slabs.push_back(static_cast<std::uint8_t>(ShellCells::slabOf(tet)));
        grid.fields[0].values.push_back(cells.prisms[prism]);
        grid.fields[1].values.push_back(cells.ghost[prism]);
    }
    return grid;
}

}  // namespace

void checkShellExtension(const std::filesystem::path& file) {
    const std::string extension = lowerCaseExtension(file);
    if (extension != ".vtu" && extension != ".msh" && extension != ".ply") {
        throw InputError(
            InputErrorCode::UnwritableFile,
            file.string() + ": the extension " + inQuotes(extension) +
                " of the output is none of .vtu, .msh, .ply"
        );
    }
}

std::string gridBytes(const std::filesystem::path& file, const TetrahedralGrid& grid) {
    return lowerCaseExtension(file) == ".vtu" ? vtuBytes(grid) : mshBytes(grid);
}

std::string shellBytes(
    const std::filesystem::path& file, const Shell& shell, const ShellFrame& frame
) {
    checkShellExtension(file);
    ShellCells cells = makeShellCells(shell, frame);
    if (lowerCaseExtension(file) == ".ply") {
        return plyBytes(cells);
    }
    return gridBytes(file, gridOf(std::move(cells)));
}

}  // namespace bspline_curve
