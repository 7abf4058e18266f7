// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/progress.h"
#include "surface/half_edges.h"
#include "surface/surface.h"

#include <span>
#include <utility>
#include <vector>

// Where more than two faces meet in an edge, mending lets pairs of them go on into each other and
// parts the others, which may leave picks on different components. For these picks further pairs
// can be chosen.
namespace bspline_curve {

/// Two faces that are to go on into each other at their common edge, the lower one first. Faces
/// share one edge at most, since those with the same vertices are removed.
using Passage = std::pair<int, int>;

/// Those of the passages (ascending) whose faces meet at an edge.
[[nodiscard]] std::vector<Passage> passagesAt(
    std::span<const HalfEdge> edge, const std::vector<Passage>& passages
);

/// The faces of a mended mesh with the vertices that they had before parts of the surface got their
/// own. `vertexOrigins`: see MeshRepair.
[[nodiscard]] std::vector<Triangle> facesBeforeParting(
    const TriangleMesh& mended, const std::vector<int>& vertexOrigins
);

/// The passages of the best ways over the faces of a mended surface, from each of some faces to the
/// next: as few as possible, then the shortest; ascending. Empty where there is no such way, or one
/// that needs none. Ways enter no face of `avoid`, ascending. Throws Cancelled. O(m n log n) for n
/// faces and m ways between components.
[[nodiscard]] std::vector<Passage> passagesBetween(
    const Surface& mended,
    const std::vector<int>& vertexOrigins,
    std::span<const int> faces,
    const std::vector<int>& avoid = {},
    const Progress& progress = {}
);

}  // namespace bspline_curve
