// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/error.h"
#include "bspline_curve/files.h"
#include "io/append_binary.h"
#include "text/text_parsing.h"

#include <array>
#include <cassert>
#include <cstdint>
#include <cstdio>

namespace bspline_curve {

namespace {

using Values = std::span<const double>;

std::string fieldPly(const TriangleMesh& mesh, Values field) {
    std::string bytes =
        "ply\nformat binary_little_endian 1.0\ncomment field on a triangle mesh, as quality\n"
        "element vertex " +
        std::to_string(mesh.vertices.size()) +
        "\nproperty double x\nproperty double y\nproperty double z\nproperty double quality\n"
        "element face " +
        std::to_string(mesh.faces.size()) +
        "\nproperty list uchar int vertex_indices\nend_header\n";
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        for (const double x : mesh.vertices[v]) {
            appendBinary(bytes, x);
        }
        appendBinary(bytes, field[v]);
    }
    for (const Triangle& face : mesh.faces) {
        appendBinary(bytes, std::uint8_t{3});
        for (const int vertex : face) {
            appendBinary(bytes, static_cast<std::int32_t>(vertex));
        }
    }
    return bytes;
}

std::string npyBytes(Values field) {
    // Magic, version 1.0, length of the header, header; the data begin at a multiple of 64.
    constexpr std::size_t kStart = 10;
    constexpr std::size_t kAlignment = 64;
    std::string header = "{'descr': '<f8', 'fortran_order': False, 'shape': (" +
                         std::to_string(field.size()) + ",), }";
    const std::size_t used = kStart + header.size() + 1;
    header.append((kAlignment - used % kAlignment) % kAlignment, ' ').append("\n");
    std::string bytes("\x93NUMPY\x01\0", 8);
    appendBinary(bytes, static_cast<std::uint16_t>(header.size()));
    bytes += header;
    for (const double value : field) {
        appendBinary(bytes, value);
    }
    return bytes;
}

std::string textBytes(Values field) {
    std::string bytes;
    std::array<char, 32> line{};
    for (const double value : field) {
        const int length = std::snprintf(line.data(), line.size(), "%.17g\n", value);
        bytes.append(line.data(), length);
    }
    return bytes;
}

}  // namespace

void checkFieldExtension(const std::filesystem::path& file) {
    const std::string extension = lowerCaseExtension(file);
    if (extension != ".ply" && extension != ".npy" && extension != ".txt") {
        throw InputError(
            InputErrorCode::UnwritableFile,
            file.string() + ": the extension " + inQuotes(extension) +
                " of the output is none of .ply, .npy, .txt"
        );
    }
}

std::string fieldBytes(
    const std::filesystem::path& file, const TriangleMesh& mesh, std::span<const double> field
) {
    checkFieldExtension(file);
    assert(field.size() == mesh.vertices.size());
    const std::string extension = lowerCaseExtension(file);
    if (extension == ".ply") {
        return fieldPly(mesh, field);
    }
    return extension == ".npy" ? npyBytes(field) : textBytes(field);
}

}  // namespace bspline_curve
