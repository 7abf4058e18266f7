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
    /// Triangles of strips count as faces.
    std::vector<std::int64_t> repeating;
};

[[nodiscard]] ParsedMesh parsePly(const std::filesystem::path& file, std::string_view bytes);
[[nodiscard]] ParsedMesh parseObj(const std::filesystem::path& file, std::string_view bytes);
[[nodiscard]] ParsedMesh parseOff(const std::filesystem::path& file, std::string_view bytes);
/// Three vertices per triangle.
[[nodiscard]] ParsedMesh parseStl(const std::filesystem::path& file, std::string_view bytes);

/// Cuts a polygon of at least three corners into triangles: a fan at its first corner where that
/// does not fold, as it never does where the polygon is flat and convex; else a triangulation of
/// least area. Vertices that are not known yet make it a fan. O(n), else O(n^3) up to 400 corners.
void addPolygon(
    std::span<const int> corners, const std::vector<Vec3>& vertices, std::vector<Triangle>& faces
);

/// Whether a vertex is named twice; sorts the corners.
[[nodiscard]] bool sortAndFindRepeated(std::span<int> corners);

}  // namespace bspline_curve
