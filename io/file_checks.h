// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/types.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

// vcglib's importers trust the counts and indices of a file: one that lies about them makes the
// importer crash, hang or drop faces in silence. These functions look through a file first, and say
// what the importer must find in it. Each throws InputError (UnreadableFile) naming file and place.
namespace bspline_curve {

enum class PlyScalar : std::uint8_t {
    None,
    Int8,
    UInt8,
    Int16,
    UInt16,
    Int32,
    UInt32,
    Float,
    Double
};

/// A triangle that the importer leaves out, with its place among all triangles.
struct OmittedTriangle {
    std::size_t place;
    Triangle corners;
};

/// What the importer must find.
struct ExpectedMesh {
    std::size_t vertices = 0;
    std::size_t triangles = 0;            ///< after polygons are cut into fans
    PlyScalar quality = PlyScalar::None;  ///< stored type of a per-vertex quality
    /// Faces of a PLY or OBJ file that name a vertex twice, ascending.
    std::vector<std::int64_t> repeating;
    std::vector<OmittedTriangle> omitted;  ///< ascending; count among `triangles`
};

[[nodiscard]] ExpectedMesh checkPly(const std::filesystem::path& file, std::string_view bytes);
[[nodiscard]] ExpectedMesh checkObj(const std::filesystem::path& file, std::string_view bytes);
/// An STL file has three vertices per triangle.
[[nodiscard]] ExpectedMesh checkStl(const std::filesystem::path& file, std::string_view bytes);

struct CheckedOff {
    ExpectedMesh expected;
    /// The same mesh in the plainest OFF: no comments, normals or colours, polygons of more than
    /// four corners cut into fans, which vcglib 2025.07 does with the wrong vertices.
    std::string text;
};

[[nodiscard]] CheckedOff checkOff(const std::filesystem::path& file, std::string_view bytes);

}  // namespace bspline_curve
