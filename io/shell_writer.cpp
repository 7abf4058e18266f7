// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/shell_writer.h"

#include "bspline_curve/error.h"
#include "io/shell_cells.h"
#include "io/text_parsing.h"

namespace bspline_curve {

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

std::string shellBytes(
    const std::filesystem::path& file, const Shell& shell, const ShellFrame& frame
) {
    checkShellExtension(file);
    const ShellCells cells = makeShellCells(shell, frame);
    const std::string extension = lowerCaseExtension(file);
    if (extension == ".vtu") {
        return vtuBytes(cells);
    }
    return extension == ".msh" ? mshBytes(cells) : plyBytes(cells);
}

}  // namespace bspline_curve
