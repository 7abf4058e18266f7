// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fill/part_filling.h"

#include <array>
#include <optional>
#include <vector>

namespace bspline_curve {

/// A mesh that was cut along curves, with flat patches on both sides of each cut.
struct CappedParts {
    FilledParts whole;        ///< all parts; patches come in pairs, of the same triangles
    std::vector<int> partOf;  ///< for each patch the part that it closes
    /// Edges of the imprinted mesh that have patches on both sides, each (lower, higher vertex),
    /// ascending.
    std::vector<std::array<int, 2>> edges;
};

/// Cuts the mesh along its curves wherever that leaves two rims with the same edges, each of them
/// once, and closes both by the same triangles, which cross neither side nor each other but where
/// `crossing` has them. Nothing where there are no such rims.
[[nodiscard]] std::optional<CappedParts> cappedOnBothSides(
    const ImprintedMesh& imprinted, const MeshParts& parts, const Progress& progress = {}
);

/// Parts of it (labels, ascending), with their patches.
[[nodiscard]] FilledParts cappedParts(const CappedParts& capped, const std::vector<int>& chosen);

}  // namespace bspline_curve
