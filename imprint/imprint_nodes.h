// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/surface.h"
#include "utility/sparse_map.h"

#include <array>
#include <cstdint>
#include <map>
#include <vector>

namespace bspline_curve {

/// Place in a face by its barycentric coordinates 1 and 2, as (x, y, 0). Every place that nodes
/// give is a multiple of 2^-52, so that sums of coordinates are exact and points of one side are
/// exactly collinear.
using FacePlace = Vec3;

/// Rounds a barycentric coordinate, or a share of an edge, to a multiple of 2^-52.
[[nodiscard]] double onGrid(double share);

/// A point at which curves meet the mesh, with what it lies on. Nodes on an edge are seen from both
/// faces at the same exact place.
struct ImprintNode {
    enum class On : std::uint8_t { Vertex, Edge, Face };

    On on = On::Face;
    /// The vertex; the edge, as 3 face + k with k the opposite corner, of the face with the lower
    /// number; or the face.
    int element = -1;
    /// On an edge: x is the share of the way from the edge's first corner in that face (k + 1) to
    /// its second. In a face: its place.
    FacePlace place = FacePlace::Zero();
};

/// How near things are taken as one, in barycentric coordinates: relative to the altitudes of the
/// face, and on an edge to its length.
class SnapDistances {
public:
    explicit SnapDistances(double usual) : usual_(usual) {}

    [[nodiscard]] double in(int face) const {
        const double* wider = wider_.find(face);
        return wider != nullptr ? *wider : usual_;
    }

    void widen(int face, double distance) { wider_.at(face, distance) = distance; }

private:
    double usual_;
    SparseMap<double> wider_;
};

/// The nodes of an imprint. A new point takes an existing node within the snapping distance, else
/// the vertex or edge of its face within that distance, else becomes a node. Which nodes come to be
/// depends on the order in which points are added, not on anything else.
class ImprintNodes {
public:
    ImprintNodes(const Surface& surface, const SnapDistances& snap)
        : surface_(surface), snap_(snap) {}

    /// The node of a point of a face. O(log n).
    int add(int face, const Vec3& barycentric);

    /// The node of a face's corner k.
    int addCorner(int face, int k) { return addAtVertex(surface_.faces()[face][k]); }

    [[nodiscard]] int count() const { return static_cast<int>(nodes_.size()); }

    [[nodiscard]] const ImprintNode& operator[](int node) const { return nodes_[node]; }

    /// Whether a node lies in a face, its sides and corners included.
    [[nodiscard]] bool isIn(int node, int face) const;
    /// The place of a node of a face in that face.
    [[nodiscard]] FacePlace placeIn(int node, int face) const;
    /// The side of a face (opposite to corner k) on which both nodes lie, or -1.
    [[nodiscard]] int commonSide(int a, int b, int face) const;
    /// The nodes in the inside of a side k of a face, from corner k + 1 to corner k + 2.
    [[nodiscard]] std::vector<int> onSide(int face, int k) const;
    /// The nodes in the inside of a face, in order of x.
    [[nodiscard]] std::vector<int> inside(int face) const;
    /// Nodes of a face in its inside, on its sides and at its corners, which become nodes.
    [[nodiscard]] std::vector<int> allIn(int face);

    [[nodiscard]] Vec3 position(int node) const;
    /// A face that holds the node, and its barycentric coordinates there.
    [[nodiscard]] SurfacePoint surfacePoint(int node) const;

    /// The edge of side k of a face as ImprintNode::element has it.
    [[nodiscard]] int edgeOf(int face, int k) const;
    /// The faces that hold a node on an edge; the second is -1 at the boundary.
    [[nodiscard]] std::array<int, 2> facesOfEdge(int edge) const;

    /// Edges with nodes in their inside, in order of their numbers.
    [[nodiscard]] std::vector<int> dividedEdges() const;

private:
    using Shares = std::multimap<double, int>;  // share or x of each node

    int addOnEdge(int face, int k, double share);
    int addAtVertex(int vertex);
    [[nodiscard]] bool isOnSide(int node, int face, int k) const;

    const Surface& surface_;
    const SnapDistances& snap_;
    std::vector<ImprintNode> nodes_;
    SparseMap<int> atVertex_;                // the node of a vertex
    std::map<int, Shares> onEdge_, inFace_;  // by edge and by face
};

}  // namespace bspline_curve
