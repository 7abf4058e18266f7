// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace bspline_curve {

/// Ids of faces, in the order of the file and not checked against a mesh: from a .npy file
/// (integers of 32 or 64 bits, little-endian, one dimension), or from any other file as a text of
/// whole numbers between blanks, with # for comments. Throws InputError (UnreadableFile: missing,
/// empty, not whole numbers, other kinds of array).
[[nodiscard]] std::vector<std::int64_t> readFaceIds(const std::filesystem::path& file);

}  // namespace bspline_curve
