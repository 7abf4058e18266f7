// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>

namespace bspline_curve {

/// A path from the environment; none where the variable is not set or empty.
[[nodiscard]] inline std::optional<std::filesystem::path> environmentPath(const char* variable) {
    const char* const value = std::getenv(variable);
    return value == nullptr || *value == '\0' ? std::nullopt
                                              : std::optional<std::filesystem::path>(value);
}

}  // namespace bspline_curve
