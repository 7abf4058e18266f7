// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/imprint.h"
#include "imprint/imprint.h"
#include "utility/go_on.h"

#include <array>
#include <vector>

namespace bspline_curve {

/// Parts of the imprinted mesh: faces that are joined across edges which are on no curve. Numbered
/// from the largest area to the smallest (equal areas: by first face). An edge of a curve that has
/// one part on both sides, as that of an open curve, parts nothing. O(n log n). Throws what `goOn`
/// throws.
[[nodiscard]] MeshParts partsOf(const ImprintedMesh& imprinted, const GoOn& goOn = [] {});

/// The edges of a curve, each as (lower, higher vertex), ascending.
[[nodiscard]] std::vector<std::array<int, 2>> edgesOf(const ImprintedCurve& curve);

/// Edges that are on curves, likewise.
[[nodiscard]] std::vector<std::array<int, 2>> curveEdges(const ImprintedMesh& imprinted);

/// The mesh opened along its curves: vertices on them are doubled, once for each fan of faces that
/// curves leave around them, so that an open curve becomes a slit with joined ends. The first fan
/// keeps the vertex; copies come last. `source` (#V of the result) names the imprinted vertex of
/// each. O(n log n).
struct CutMesh {
    TriangleMesh mesh;
    std::vector<int> source;
};

[[nodiscard]] CutMesh cutAlongCurves(const ImprintedMesh& imprinted);

/// Likewise along any edges of a mesh, each (lower, higher vertex), ascending.
[[nodiscard]] CutMesh cutAlongEdges(
    const TriangleMesh& mesh, const std::vector<std::array<int, 2>>& edges
);

/// The mesh with a copy of each of the given vertices for each fan of faces around it but the
/// first. O(n log n).
[[nodiscard]] CutMesh partFans(const TriangleMesh& mesh, const std::vector<int>& vertices);

/// Some faces of a mesh with the vertices that they use, in order. O(n).
struct SubMesh {
    TriangleMesh mesh;
    std::vector<int> vertices;  ///< for each vertex of `mesh` the one of the whole
    std::vector<int> faces;     ///< likewise for faces
};

/// The faces whose label is one of `chosen` (ascending).
[[nodiscard]] SubMesh facesWithLabels(
    const TriangleMesh& mesh, const std::vector<int>& labels, const std::vector<int>& chosen
);

}  // namespace bspline_curve
