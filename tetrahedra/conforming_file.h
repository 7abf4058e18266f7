// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/progress.h"
#include "bspline_curve/whole_shell.h"

#include <filesystem>
#include <string>

namespace bspline_curve {

/// The bytes of a file (.vtu or .msh) of the tetrahedra of conformToSurface(). Throws likewise.
[[nodiscard]] std::string conformingFileBytes(
    const std::filesystem::path& file, const WholeShell& shell, const Progress& progress = {}
);

}  // namespace bspline_curve
