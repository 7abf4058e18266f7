// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/mesh_writer.h"

#include "bspline_curve/error.h"
#include "io/append_binary.h"
#include "io/number_text.h"
#include "io/text_parsing.h"

#include <Eigen/Geometry>

#include <cstddef>

namespace bspline_curve {

namespace {

std::string meshPly(const TriangleMesh& mesh, const MeshAttributes& attributes) {
    const bool hasQuality = !attributes.vertexQuality.empty();
    const bool hasLabels = !attributes.faceLabels.empty();
    const bool hasColours = !attributes.faceColours.empty();
    std::string bytes =
        "ply\nformat binary_little_endian 1.0\nelement vertex " +
        std::to_string(mesh.vertices.size()) +
        "\nproperty double x\nproperty double y\nproperty double z\n" +
        (hasQuality ? "property double quality\n" : "") + "element face " +
        std::to_string(mesh.faces.size()) + "\nproperty list uchar int vertex_indices\n" +
        (hasLabels ? "property int label\nproperty double quality\n" : "") +
        (hasColours ? "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty "
                      "uchar alpha\n"
                    : "") +
        "end_header\n";
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        for (const double x : mesh.vertices[v]) {
            appendBinary(bytes, x);
        }
        if (hasQuality) {
            appendBinary(bytes, attributes.vertexQuality[v]);
        }
    }
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        appendBinary(bytes, std::uint8_t{3});
        for (const int vertex : mesh.faces[f]) {
            appendBinary(bytes, static_cast<std::int32_t>(vertex));
        }
        if (hasLabels) {
            appendBinary(bytes, static_cast<std::int32_t>(attributes.faceLabels[f]));
            appendBinary(bytes, static_cast<double>(attributes.faceLabels[f]));
        }
        if (hasColours) {
            for (const std::uint8_t channel : attributes.faceColours[f]) {
                appendBinary(bytes, channel);
            }
            appendBinary(bytes, std::uint8_t{255});
        }
    }
    return bytes;
}

std::string numbersOf(const Vec3& point) {
    return numberText(point.x()) + " " + numberText(point.y()) + " " + numberText(point.z());
}

std::string objBytes(const TriangleMesh& mesh) {
    std::string text;
    for (const Vec3& vertex : mesh.vertices) {
        text += "v ";
        text += numbersOf(vertex);
        text += '\n';
    }
    for (const Triangle& face : mesh.faces) {
        text += 'f';
        for (const int vertex : face) {
            text += ' ';
            text += std::to_string(vertex + 1);
        }
        text += '\n';
    }
    return text;
}

std::string offBytes(const TriangleMesh& mesh) {
    std::string text = "OFF\n" + std::to_string(mesh.vertices.size()) + " " +
                       std::to_string(mesh.faces.size()) + " 0\n";
    for (const Vec3& vertex : mesh.vertices) {
        text += numbersOf(vertex);
        text += '\n';
    }
    for (const Triangle& face : mesh.faces) {
        text += '3';
        for (const int vertex : face) {
            text += ' ';
            text += std::to_string(vertex);
        }
        text += '\n';
    }
    return text;
}

std::string meshStl(const TriangleMesh& mesh) {
    constexpr std::size_t kTextSize = 80;
    std::string bytes(kTextSize, ' ');
    appendBinary(bytes, static_cast<std::uint32_t>(mesh.faces.size()));
    for (const auto& [a, b, c] : mesh.faces) {
        const Vec3 &p = mesh.vertices[a], &q = mesh.vertices[b], &r = mesh.vertices[c];
        const Vec3 normal = (q - p).cross(r - p).normalized();
        for (const Vec3& row : {normal, p, q, r}) {
            for (const double x : row) {
                appendBinary(bytes, static_cast<float>(x));
            }
        }
        appendBinary(bytes, std::uint16_t{0});
    }
    return bytes;
}

}  // namespace

std::string meshExtensions() {
    return ".ply, .obj, .off or .stl";
}

void checkMeshExtension(const std::filesystem::path& file) {
    const std::string extension = lowerCaseExtension(file);
    if (extension != ".ply" && extension != ".obj" && extension != ".off" && extension != ".stl") {
        throw InputError(
            InputErrorCode::UnwritableFile,
            file.string() + ": meshes are written as " + meshExtensions() +
                "; change the name's end"
        );
    }
}

std::string meshBytes(
    const std::filesystem::path& file, const TriangleMesh& mesh, const MeshAttributes& attributes
) {
    checkMeshExtension(file);
    const std::string extension = lowerCaseExtension(file);
    if (extension == ".obj") {
        return objBytes(mesh);
    }
    if (extension == ".off") {
        return offBytes(mesh);
    }
    return extension == ".stl" ? meshStl(mesh) : meshPly(mesh, attributes);
}

}  // namespace bspline_curve
