// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"
#include "io/ply_header.h"

#include <array>
#include <filesystem>
#include <string>
#include <vector>

// What mesh files hold beside vertices, faces and quality: colours, normals, textures, groups.
namespace bspline_curve {

/// One number for each vertex or face, as a PLY file names it.
struct MeshChannel {
    std::string name;
    PlyScalar type = PlyScalar::Float;
    std::vector<double> values;
};

struct MeshExtras {
    /// Of vertices: red, green, blue, nx, ny, nz, s, t, and all others that the file has.
    std::vector<MeshChannel> vertices;
    std::vector<MeshChannel> faces;  ///< per face, as the mesh has them, in triangles
    /// Texture coordinates u, v and normals of the corners of each face; empty: there are none.
    std::vector<std::array<Eigen::Vector2d, 3>> cornerTexture;
    std::vector<std::array<Vec3, 3>> cornerNormals;
    std::vector<std::string> textures;   ///< names of files
    std::vector<std::string> libraries;  ///< of materials: what follows mtllib in OBJ
    /// Lines of OBJ that stand before faces (o, g, s, usemtl), and for each face which of these,
    /// -1: none. Empty: there are none.
    std::vector<std::string> headings;
    std::vector<int> headingOf;

    [[nodiscard]] bool empty() const {
        return vertices.empty() && faces.empty() && cornerTexture.empty() &&
               cornerNormals.empty() && libraries.empty() && headings.empty();
    }

    /// What there is, in words: "colours, texture coordinates".
    [[nodiscard]] std::string words() const;
};

/// Those of a .ply or .obj file that readMeshFile() has read; none of other formats. Throws
/// InputError (UnreadableFile). O(n).
[[nodiscard]] MeshExtras readMeshExtras(const std::filesystem::path& file);

}  // namespace bspline_curve
