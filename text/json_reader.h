// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string_view>

namespace bspline_curve {

/// The JSON in a file's bytes; `file` is for messages. Throws InputError (UnreadableFile) where
/// they are not JSON, with line and column, and where arrays and objects nest more than 64 deep,
/// which no file of picks, curve or report does: each further "[" would take some fifty times its
/// own byte. O(n).
[[nodiscard]] nlohmann::json jsonOfBytes(const std::filesystem::path& file, std::string_view bytes);

}  // namespace bspline_curve
