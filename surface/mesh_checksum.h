// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

#include <array>
#include <cstdint>
#include <string>

namespace bspline_curve {

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
