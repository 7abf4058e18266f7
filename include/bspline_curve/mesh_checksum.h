// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

#include <array>
#include <cstdint>
#include <string>

namespace bspline_curve {

/// By what a mesh is known again: how many vertices and faces, and the CRC-32 (that of zlib and
/// PNG) of x y z of each vertex as little-endian floats, then of the three vertices of each face as
/// little-endian 32-bit integers. Coordinates are rounded to floats, and -0 counts as 0, so that
/// programs with floats and with doubles agree. The same on every platform.
struct MeshChecksum {
    std::int64_t vertices = 0;
    std::int64_t faces = 0;
    std::uint32_t crc32 = 0;

    friend bool operator==(const MeshChecksum&, const MeshChecksum&) = default;

    /// The CRC-32 as 8 hexadecimal digits.
    [[nodiscard]] std::string digits() const;
};

/// O(n).
[[nodiscard]] MeshChecksum checksumOf(const TriangleMesh& mesh);

/// Takes a mesh element by element: first all vertices, then all faces.
class MeshChecksumBuilder {
public:
    void addVertex(const Vec3& position);
    void addFace(const Triangle& face);
    [[nodiscard]] MeshChecksum checksum() const;

private:
    void add(std::uint32_t word);

    MeshChecksum counts_;
    std::uint32_t register_ = ~std::uint32_t{0};
};

/// How a mesh differs from the one of a checksum, for messages: "it had 12 faces then and has 14
/// now", or that coordinates or the order differ.
[[nodiscard]] std::string describeChange(const MeshChecksum& then, const MeshChecksum& now);

}  // namespace bspline_curve
