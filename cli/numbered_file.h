// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>

namespace bspline_curve::cli {

/// The name of one of several files: FILE.ply, FILE-2.ply, …; also FILE-2.bspline.dxf.
[[nodiscard]] std::filesystem::path numberedFile(
    const std::filesystem::path& file, std::size_t index
);

}  // namespace bspline_curve::cli
