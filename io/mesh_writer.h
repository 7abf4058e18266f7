// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

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
};

/// The file name extensions that meshBytes() knows, for messages: ".ply, .obj, .off or .stl".
[[nodiscard]] std::string meshExtensions();

/// Throws InputError (UnwritableFile) where a mesh cannot be written under this name.
void checkMeshExtension(const std::filesystem::path& file);

/// The bytes of a mesh file: .ply (binary, little-endian, doubles, with attributes), .obj and .off
/// (text, shortest decimals that read back as the same doubles, without attributes) or .stl
/// (binary, floats, without attributes). Throws InputError (UnwritableFile) for other extensions.
[[nodiscard]] std::string meshBytes(
    const std::filesystem::path& file,
    const TriangleMesh& mesh,
    const MeshAttributes& attributes = {}
);

}  // namespace bspline_curve
