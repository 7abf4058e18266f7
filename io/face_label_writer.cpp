// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/face_label_writer.h"

#include "bspline_curve/error.h"
#include "io/append_binary.h"
#include "io/text_parsing.h"

#include <cstdint>

namespace bspline_curve {

std::string faceLabelBytes(
    const std::filesystem::path& file, const TriangleMesh& mesh, std::span<const int> labels
) {
    if (lowerCaseExtension(file) != ".ply") {
        throw InputError(
            InputErrorCode::UnwritableFile,
            file.string() + ": labels of faces are written as .ply; change the name's end"
        );
    }
    std::string bytes =
        "ply\nformat binary_little_endian 1.0\ncomment a triangle mesh with labels of its faces\n"
        "element vertex " +
        std::to_string(mesh.vertices.size()) +
        "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
        std::to_string(mesh.faces.size()) +
        "\nproperty list uchar int vertex_indices\nproperty int label\nproperty double "
        "quality\nend_header\n";
    for (const Vec3& vertex : mesh.vertices) {
        for (const double x : vertex) {
            appendBinary(bytes, x);
        }
    }
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        appendBinary(bytes, std::uint8_t{3});
        for (const int vertex : mesh.faces[f]) {
            appendBinary(bytes, static_cast<std::int32_t>(vertex));
        }
        appendBinary(bytes, static_cast<std::int32_t>(labels[f]));
        appendBinary(bytes, static_cast<double>(labels[f]));
    }
    return bytes;
}

}  // namespace bspline_curve
