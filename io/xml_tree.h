// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/files.h"

#include <filesystem>
#include <string_view>

namespace bspline_curve {

/// The root element of a document. Throws InputError (UnreadableFile) with the line where it is not
/// XML.
[[nodiscard]] XmlElement xmlTreeOf(const std::filesystem::path& file, std::string_view bytes);

}  // namespace bspline_curve
