// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"
#include "io/mesh_extras.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

namespace bspline_curve {

/// What a mesh file holds beside vertices and faces; empty: nothing of that.
struct MeshAttributes {
    std::span<const double> vertexQuality{};  ///< `quality` of vertices
    /// `label` (int) of faces, and the same as their `quality` (double), which MeshLab shows and
    /// selects by.
    std::span<const int> faceLabels{};
    std::span<const std::array<std::uint8_t, 3>> faceColours{};
    const MeshExtras* extras = nullptr;  ///< of this mesh; what is above goes before it
};

/// The file name extensions that meshBytes() knows, for messages: ".ply, .obj, .off or .stl".
[[nodiscard]] std::string meshExtensions();

/// Throws InputError (UnwritableFile) where a mesh cannot be written under this name.
void checkMeshExtension(const std::filesystem::path& file);

/// What of extras a file of that name cannot hold, in words: "colours, normals"; empty: nothing.
[[nodiscard]] std::string lostExtras(const std::filesystem::path& file, const MeshExtras& extras);

/// How far a file of that name moves a vertex at most: .stl holds floats.
[[nodiscard]] double largestMoveIn(const std::filesystem::path& file, const TriangleMesh& mesh);

/// The bytes of a mesh file: .ply (binary, little-endian, doubles, with all attributes but headings
/// and libraries of materials), .obj (text, shortest decimals that read back as the same doubles,
/// with colours, normals, texture coordinates, groups and materials), .off (likewise, without
/// attributes) or .stl (binary, floats, without attributes). Throws InputError (UnwritableFile) for
/// other extensions.
[[nodiscard]] std::string meshBytes(
    const std::filesystem::path& file,
    const TriangleMesh& mesh,
    const MeshAttributes& attributes = {}
);

}  // namespace bspline_curve
