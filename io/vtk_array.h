// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/append_binary.h"
#include "io/base64.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace bspline_curve {

/// An array of `count` values as VTK's XML has it: base64 of its size and then its bytes.
template <class Number, class ValueAt>
[[nodiscard]] std::string vtkArray(
    const std::string& type,
    const std::string& name,
    int components,
    std::size_t count,
    const ValueAt& valueAt
) {
    std::string bytes;
    bytes.reserve(sizeof(std::uint64_t) + count * sizeof(Number));
    appendBinary(bytes, static_cast<std::uint64_t>(count * sizeof(Number)));
    for (std::size_t i = 0; i < count; ++i) {
        appendBinary(bytes, static_cast<Number>(valueAt(i)));
    }
    std::string text = R"(<DataArray type=")";
    text.append(type).append(R"(" Name=")").append(name);
    if (components > 1) {  // meshio makes a table of one column where one is named
        text.append(R"(" NumberOfComponents=")").append(std::to_string(components));
    }
    return text.append(R"(" format="binary">)").append(base64(bytes)).append("</DataArray>\n");
}

/// Begins a file of unstructured cells that hold their arrays in this way.
inline constexpr const char* kVtuStart =
    "<?xml version=\"1.0\"?>\n"
    "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
    "header_type=\"UInt64\">\n<UnstructuredGrid>\n";
inline constexpr const char* kVtuEnd = "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";

}  // namespace bspline_curve
