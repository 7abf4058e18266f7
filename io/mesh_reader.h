// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace bspline_curve {

struct MeshFile {
    TriangleMesh mesh;
    std::vector<double> quality;  ///< one value per vertex, or empty where the file has none
};

/// What to do with faces that name a vertex twice.
enum class RepeatedVertices : std::uint8_t { Refuse, Keep };

/// A mesh with its per-vertex quality (PLY only): .ply, .obj, .off and .stl.
/// Coordinates keep the precision of the file; vertices and faces keep its order. Polygons are cut
/// into triangles: fans at their first corner, or, where a fan folds, triangulations of least area.
/// Strips of triangles are read where a PLY file has no faces. The vertices of an STL file that
/// have equal coordinates are made one, in order of first use. Only what the file says is checked,
/// not whether it is a surface. Throws InputError (UnreadableFile, or DegenerateFace where a face
/// of a PLY or OBJ file names a vertex twice and is not to be kept), naming file and reason.
[[nodiscard]] MeshFile readMeshFile(
    const std::filesystem::path& file, RepeatedVertices repeated = RepeatedVertices::Refuse
);

/// The same without quality.
[[nodiscard]] TriangleMesh readMesh(const std::filesystem::path& file);

}  // namespace bspline_curve
