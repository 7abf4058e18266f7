// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pattern/drawing.h"

#include <filesystem>
#include <string_view>

namespace bspline_curve {

/// The outlines of a line of text, in UTF-8, in the letters of a font file (TrueType, OpenType,
/// Type 1): one unit is the font's em, and the letters stand on y = 0, the baseline. Kerning is
/// that of the font's table `kern`. Throws InputError (UnreadableFile: no font with outlines, no
/// glyph for a character; BadOption: no UTF-8, nothing but blanks, or this library was built
/// without FreeType).
[[nodiscard]] Drawing textOutlines(std::string_view text, const std::filesystem::path& font);

}  // namespace bspline_curve
