// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace bspline_curve {

/// The path that a host names in UTF-8, whatever the locale.
[[nodiscard]] inline std::filesystem::path utf8Path(const std::string& text) {
    return {std::u8string(text.begin(), text.end())};
}

/// The text in UTF-8 by which hosts name a path.
[[nodiscard]] inline std::string utf8Text(const std::filesystem::path& path) {
    const std::u8string text = path.u8string();
    return {text.begin(), text.end()};
}

}  // namespace bspline_curve
