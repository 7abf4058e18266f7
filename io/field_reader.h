// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

namespace bspline_curve {

/// One value per vertex, in the order of the mesh's vertices: from a .npy file (float32 or float64,
/// little-endian, one dimension), or from any other file as a text of numbers between blanks, with
/// # for comments. Throws InputError: UnreadableFile (missing, not numbers, other kinds of array),
/// BadField (other than `vertexCount` values, or values that are not finite, with the ids of their
/// vertices).
[[nodiscard]] std::vector<double> readField(
    const std::filesystem::path& file, std::size_t vertexCount
);

}  // namespace bspline_curve
