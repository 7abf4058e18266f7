// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

// The font of texts that was given last in MeshLab's window, over its ends; in UTF-8.
namespace bspline_curve {

/// Empty where none was given, where its file is gone, and in hosts without a window.
[[nodiscard]] std::string keptFont();

/// Does nothing in hosts without a window.
void keepFont(const std::string& file);

}  // namespace bspline_curve
