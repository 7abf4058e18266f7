// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/half_edges.h"
#include "surface/surface.h"

#include <utility>
#include <vector>

// Where more than two faces meet in an edge, mending lets pairs of them go on into each other and
// parts the others; it cuts a few edges of two faces besides. A curve may pass from any face of an
// edge to any other all the same: for its way, faces are joined anew.
namespace bspline_curve {

/// Two faces that are to go on into each other at their common edge, the lower one first. Faces
/// share one edge at most, since those with the same vertices are removed.
using Passage = std::pair<int, int>;

/// A side of a face, opposite to its corner side % 3.
[[nodiscard]] constexpr int sideOf(int face, int k) {
    return 3 * face + k;
}

/// The edges of a mended surface at which faces are parted that meet there, and open slits: pairs
/// of boundary edges that lie on each other.
class PartedEdges {
public:
    struct Edge {
        std::vector<int> sides;  ///< ascending
        bool isSlit;             ///< its faces have no vertices in common
        Vec3 middle;
        double length;
    };

    /// `roots`: one number for all vertices of the surface that are one in the given mesh, see
    /// MeshRepair::vertexRoots(). `findsSlits`: looks for open slits as well. O(n).
    PartedEdges(const Surface& surface, const std::vector<int>& roots, bool findsSlits = false);

    [[nodiscard]] const std::vector<Edge>& edges() const { return edges_; }

    [[nodiscard]] bool empty() const { return edges_.empty(); }

    /// The edge that a side of a face lies on, or -1. O(log n).
    [[nodiscard]] int edgeAt(int side) const;

private:
    void add(const Surface& surface, std::vector<int> sides, bool isSlit);

    std::vector<Edge> edges_;
    std::vector<std::pair<int, int>> edgeOfSide_;  // ascending
};

/// The faces of a mended mesh with the roots of their vertices, see PartedEdges.
[[nodiscard]] std::vector<Triangle> facesBeforeParting(
    const TriangleMesh& mended, const std::vector<int>& roots
);

/// A step of a way from one face to the next, over sides of theirs at one edge.
struct Step {
    int from, to;  ///< sides
    double share;  ///< of the edge's length, from its end with the lower coordinates
    int edge;      ///< of PartedEdges, or -1
};

/// Where ways lead over a parted edge: the stretch of it, by shares, at which two faces are joined.
struct Stretch {
    int edge;
    double begin, end;
    std::pair<int, int> sides;  ///< ascending
    auto operator<=>(const Stretch&) const = default;
};

/// What some ways over the faces need to be joined.
struct Passages {
    std::vector<Stretch> stretches;  ///< ascending; an edge is divided where its pairs share a face
    /// All other steps, pairs of sides in the order of the ways, which one-sided surfaces must not
    /// be cut at.
    std::vector<std::pair<int, int>> strips;
    bool operator==(const Passages&) const = default;
};

/// The passages of steps of ways one after the other.
[[nodiscard]] Passages passagesOf(const std::vector<Step>& steps);

}  // namespace bspline_curve
