// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/error.h"
#include "bspline_curve/files.h"
#include "io/append_binary.h"
#include "io/mesh_formats.h"
#include "text/number_text.h"
#include "text/text_parsing.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

namespace bspline_curve {

namespace {

std::string numbersOf(const Vec3& point) {
    return numberText(point.x()) + " " + numberText(point.y()) + " " + numberText(point.z());
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

std::string lostExtras(const std::filesystem::path& file, const MeshExtras& extras) {
    const std::string extension = lowerCaseExtension(file);
    MeshExtras lost = extras;
    if (extension == ".ply") {
        lost.vertices.clear();
        lost.faces.clear();
        lost.cornerTexture.clear();
        lost.cornerNormals.clear();
    } else if (extension == ".obj") {
        constexpr std::array<std::string_view, 13> kHeld{
            "red",
            "green",
            "blue",
            "alpha",
            "nx",
            "ny",
            "nz",
            "s",
            "t",
            "u",
            "v",
            "texture_u",
            "texture_v"
        };
        std::erase_if(lost.vertices, [&](const MeshChannel& channel) {
            return std::ranges::find(kHeld, channel.name) != kHeld.end();
        });
        lost.cornerTexture.clear();
        lost.cornerNormals.clear();
        lost.libraries.clear();
        lost.headings.clear();
    }
    return lost.words();
}

double largestMoveIn(const std::filesystem::path& file, const TriangleMesh& mesh) {
    double largest = 0.0;
    if (lowerCaseExtension(file) == ".stl") {
        for (const Vec3& p : mesh.vertices) {
            largest = std::max(largest, (p - p.cast<float>().cast<double>()).norm());
        }
    }
    return largest;
}

std::string meshBytes(
    const std::filesystem::path& file, const TriangleMesh& mesh, const MeshAttributes& attributes
) {
    checkMeshExtension(file);
    const std::string extension = lowerCaseExtension(file);
    if (extension == ".obj") {
        return meshObj(mesh, attributes);
    }
    if (extension == ".off") {
        return offBytes(mesh);
    }
    return extension == ".stl" ? meshStl(mesh) : meshPly(mesh, attributes);
}

}  // namespace bspline_curve
