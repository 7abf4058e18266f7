// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

// One parser per format of meshes. Each throws InputError (UnreadableFile) naming file and place
// where a count, an index or a number is not what it has to be.
namespace bspline_curve {

struct ParsedMesh {
    TriangleMesh mesh;
    std::vector<double> quality;  ///< one value per vertex (PLY only), or empty
    /// Faces of a PLY or OBJ file, before polygons are cut, that name a vertex twice; ascending.
    std::vector<std::int64_t> repeating;
};

[[nodiscard]] ParsedMesh parsePly(const std::filesystem::path& file, std::string_view bytes);
[[nodiscard]] ParsedMesh parseObj(const std::filesystem::path& file, std::string_view bytes);
[[nodiscard]] ParsedMesh parseOff(const std::filesystem::path& file, std::string_view bytes);
/// Three vertices per triangle.
[[nodiscard]] ParsedMesh parseStl(const std::filesystem::path& file, std::string_view bytes);

/// Cuts a polygon of at least three corners into triangles that share its first corner.
void addFan(std::span<const int> corners, std::vector<Triangle>& faces);

/// Whether a vertex is named twice; sorts the corners.
[[nodiscard]] bool sortAndFindRepeated(std::span<int> corners);

}  // namespace bspline_curve
