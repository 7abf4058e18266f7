// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

#include <utility>
#include <vector>

namespace bspline_curve {

/// The faces at every vertex of a mesh.
struct VertexFaces {
    std::vector<int> offsets;  ///< #V + 1; the faces at v are faces[offsets[v] .. offsets[v + 1])
    std::vector<int> faces;    ///< 3 #F
};

/// The faces at every vertex, ascending. O(n). Expects checked arrays.
[[nodiscard]] VertexFaces listFacesAtVertices(const TriangleMesh& mesh);

/// How the faces of a mesh are joined along edges and around vertices.
struct FaceAdjacency {
    /// "#F by 3": entry k is the face across the edge opposite to vertex k, or -1.
    std::vector<Triangle> neighbours;
    VertexFaces facesAround;       ///< in counter-clockwise order (see Surface::facesAround)
    std::vector<char> isBoundary;  ///< #V; 1 where the faces around a vertex are an open fan
    /// Mean length of all edges, each counted once.
    double averageEdgeLength = 0.0;
};

/// Joins faces that use the same two vertices, in opposite directions. `listed`: what
/// listFacesAtVertices gives. O(n log d) for at most d faces at a vertex, on two threads where
/// there are many faces; 12 bytes per face of scratch memory. The result, the mean length's last
/// digit included, does not depend on the threads. Throws InputError: NonManifoldEdge (the faces at
/// edges with more than two faces, and pairs of faces with the same three vertices), else
/// InconsistentOrientation (the faces at edges that both faces use in the same direction), else
/// NonManifoldVertex (vertices around which the faces are more than one fan). Expects faces that
/// checkFacesHaveArea accepts.
[[nodiscard]] FaceAdjacency joinFaces(const TriangleMesh& mesh, VertexFaces listed);

/// Connected components of the faces across edges: the component of each face, numbered from 0 in
/// order of their first faces, and how many there are. O(n log n) at worst, O(n) where faces that
/// are near in space are near in number.
[[nodiscard]] std::pair<std::vector<int>, int> labelComponents(
    const std::vector<Triangle>& neighbours
);

}  // namespace bspline_curve
