// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/types.h"

#include <vector>

namespace bspline_curve {

/// How the faces of a mesh are joined along edges.
struct FaceAdjacency {
    /// "#F by 3": entry k is the face across the edge opposite to vertex k, or -1.
    std::vector<Triangle> neighbours;
    /// Mean length of all edges, each counted once.
    double averageEdgeLength = 0.0;
};

/// Joins faces that use the same two vertices, in opposite directions. O(n log d) for at most d
/// edges at a vertex; 24 bytes per face and 4 per vertex of scratch memory.
/// Throws InputError: NonManifoldEdge (the faces at edges with more than two faces, and pairs of
/// faces with the same three vertices), else InconsistentOrientation (the faces at edges that
/// both faces use in the same direction). Expects faces that checkFacesHaveArea accepts.
[[nodiscard]] FaceAdjacency joinFacesAlongEdges(const TriangleMesh& mesh);

/// The faces around every vertex, in counter-clockwise order (see Surface::facesAround).
struct VertexFans {
    std::vector<int> offsets;      ///< #V + 1; the faces at v are faces[offsets[v] .. offsets[v+1])
    std::vector<int> faces;        ///< 3 #F
    std::vector<char> isBoundary;  ///< #V; 1 where the fan is open
};

/// Throws InputError: NonManifoldVertex, where the faces around a vertex are more than one fan
/// (vertices). O(n).
[[nodiscard]] VertexFans orderFacesAroundVertices(
    const TriangleMesh& mesh, const std::vector<Triangle>& neighbours
);

struct FaceComponents {
    std::vector<int> componentOf;  ///< #F, numbered from 0 in order of their first faces
    int count = 0;
};

/// Connected components of the faces across edges. O(n).
[[nodiscard]] FaceComponents labelComponents(const std::vector<Triangle>& neighbours);

}  // namespace bspline_curve
