// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

#include <filesystem>
#include <span>
#include <string>

namespace bspline_curve {

/// Throws InputError (UnwritableFile) where fieldBytes knows no format for the extension.
void checkFieldExtension(const std::filesystem::path& file);

/// The bytes of a file with one value per vertex, in the order of the mesh's vertices, all of them
/// without loss; the format by the extension of `file`:
///   .ply   the mesh, binary, little-endian; vertex: x y z quality (double); face: vertex_indices
///   .npy   float64, little-endian, one dimension
///   .txt   one number a line
/// readField reads the last two. Throws InputError (UnwritableFile).
[[nodiscard]] std::string fieldBytes(
    const std::filesystem::path& file, const TriangleMesh& mesh, std::span<const double> field
);

}  // namespace bspline_curve
