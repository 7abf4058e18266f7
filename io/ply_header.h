// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/files.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace bspline_curve {

struct PlyProperty {
    std::string name;
    PlyScalar type = PlyScalar::None;
    PlyScalar countType = PlyScalar::None;  ///< None: not a list
};

struct PlyElement {
    std::string name;
    std::size_t count = 0;
    std::vector<PlyProperty> properties;
};

enum class PlyFormat : std::uint8_t { Ascii, LittleEndian, BigEndian };

struct PlyHeader {
    PlyFormat format = PlyFormat::Ascii;
    std::vector<PlyElement> elements;
    std::size_t size = 0;   ///< in bytes; the data follow
    std::size_t lines = 0;  ///< of the header
};

/// Throws InputError (UnreadableFile) naming file and line.
[[nodiscard]] PlyHeader readPlyHeader(const std::filesystem::path& file, std::string_view bytes);

/// A property by its name; nullptr where there is none.
[[nodiscard]] const PlyProperty* findProperty(const PlyElement& element, std::string_view name);

/// "uchar", as headers have it.
[[nodiscard]] std::string nameOf(PlyScalar type);
/// In a binary file, in bytes.
[[nodiscard]] std::size_t sizeOf(PlyScalar type);
[[nodiscard]] bool isFloating(PlyScalar type);

}  // namespace bspline_curve
