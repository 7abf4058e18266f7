// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "design/surface_walk.h"

#include <cstddef>
#include <span>

namespace bspline_curve {

/// A point of a path that is faired.
struct FairingNode : SurfaceNode {
    Vec3 normal = Vec3::Zero();  ///< of the faces around, unit
    /// Derivatives of that by u and by v of the foot, but for what they have along it.
    Vec3 normalByU = Vec3::Zero(), normalByV = Vec3::Zero();
};

/// Nodes in a row, or round a closed path, and the segments between them.
struct NodeRow {
    std::size_t size = 0;
    bool closed = false;

    [[nodiscard]] std::size_t segmentCount() const { return size - (closed ? 0 : 1); }

    [[nodiscard]] std::size_t before(std::size_t i) const { return i > 0 ? i - 1 : size - 1; }

    [[nodiscard]] std::size_t after(std::size_t i) const { return i + 1 < size ? i + 1 : 0; }

    [[nodiscard]] bool hasBefore(std::size_t i) const { return closed || i > 0; }

    [[nodiscard]] bool hasAfter(std::size_t i) const { return closed || i + 1 < size; }

    [[nodiscard]] bool hasTurn(std::size_t i) const { return hasBefore(i) && hasAfter(i); }

    /// From a node to the one after it.
    [[nodiscard]] Vec3 segment(std::span<const FairingNode> nodes, std::size_t i) const {
        return nodes[after(i)].position - nodes[i].position;
    }
};

}  // namespace bspline_curve
