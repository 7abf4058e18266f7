// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace bspline_curve {

/// The path that a host names in UTF-8, whatever the locale.
[[nodiscard]] inline std::filesystem::path utf8Path(const std::string& text) {
    return {std::u8string(text.begin(), text.end())};
}

}  // namespace bspline_curve
