// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

#include <filesystem>
#include <span>
#include <string>

namespace bspline_curve {

/// The bytes of a .ply, binary, little-endian: the mesh with a label of each face, as the
/// properties `label` (int) and `quality` (double, which MeshLab shows and selects by). Throws
/// InputError (UnwritableFile) where the file's name does not end in .ply.
[[nodiscard]] std::string faceLabelBytes(
    const std::filesystem::path& file, const TriangleMesh& mesh, std::span<const int> labels
);

}  // namespace bspline_curve
