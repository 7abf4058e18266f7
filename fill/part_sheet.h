// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fill/part_filling.h"

#include <vector>

namespace bspline_curve {

/// An edge of a rim, in the direction of its face.
struct RimEdge {
    int from, to;  ///< vertices of the sheet
    int face;      ///< of the imprinted mesh
};

/// Chosen parts by themselves, opened along the curves around them alone: what a solid is made of.
struct PartSheet {
    FilledParts parts;
    std::vector<RimEdge> rim;  ///< all of the boundary
    /// For each vertex the first one that comes from the same vertex of the imprint: another one
    /// where the parts meet themselves in a vertex.
    std::vector<int> first;

    /// The vertices of the rim, ascending.
    [[nodiscard]] std::vector<int> rimVertices() const;
};

/// `chosen`: labels, ascending. O(n log n).
[[nodiscard]] PartSheet sheetOf(
    const ImprintedMesh& imprinted, const MeshParts& parts, const std::vector<int>& chosen
);

/// Adds the two faces between an edge of a rim and where its ends are moved to, so that they go on
/// from the face at the rim.
void addWall(FilledParts& solid, const RimEdge& edge, int movedFrom, int movedTo);

/// Gives all faces after those of the imprint no label.
void endSolid(FilledParts& solid);

}  // namespace bspline_curve
