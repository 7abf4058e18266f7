// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/surface.h"
#include "utility/sparse_map.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace bspline_curve {

/// Place in a face by its barycentric coordinates 1 and 2, as (x, y, 0). Every place that nodes
/// give is a multiple of 2^-52, so that sums of coordinates are exact and points of one side are
/// exactly collinear.
using FacePlace = Vec3;

/// Barycentric coordinates of a place.
[[nodiscard]] inline Vec3 barycentricAt(const FacePlace& place) {
    return {1.0 - place.x() - place.y(), place.x(), place.y()};
}

/// Where curves meet the mesh, off its vertices. A node on an edge is seen from both faces at the
/// same exact place.
struct ImprintNode {
    enum class On : std::uint8_t { Edge, Face };

    On on = On::Face;
    /// The edge, as 3 face + k with k the opposite corner, of the face with the lower number; or
    /// the face.
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

/// The nodes of an imprint, by number: from 0 on those off the vertices of the mesh, ~v for vertex
/// v. A new point takes an existing node within the snapping distance, else the vertex or edge of
/// its face within that distance, else becomes a node. Which nodes come to be depends on the order
/// in which points are added, not on anything else.
class ImprintNodes {
public:
    ImprintNodes(const Surface& surface, const SnapDistances& snap)
        : surface_(surface), snap_(snap) {}

    /// The node of a point of a face. O(n) for n nodes on its edge or in its face at worst,
    /// O(log n) but for moving numbers.
    int add(int face, const Vec3& barycentric);

    /// Of those off the vertices.
    [[nodiscard]] int count() const { return static_cast<int>(nodes_.size()); }

    /// Expects a node off the vertices.
    [[nodiscard]] const ImprintNode& operator[](int node) const { return nodes_[node]; }

    /// The place of a node of a face in that face.
    [[nodiscard]] FacePlace placeIn(int node, int face) const;
    /// The side of a face (opposite to corner k) on which both nodes lie, or -1. Expects nodes of
    /// the face.
    [[nodiscard]] int commonSide(int a, int b, int face) const;
    /// Appends the nodes in the inside of a side k of a face, from corner k + 1 to corner k + 2.
    void appendOnSide(int face, int k, std::vector<int>& nodes) const;
    /// Appends the nodes in the inside of a face, in order of x.
    void appendInside(int face, std::vector<int>& nodes) const;

    [[nodiscard]] Vec3 position(int node) const;
    /// The face and the barycentric coordinates of a node off the vertices.
    [[nodiscard]] SurfacePoint surfacePoint(int node) const;

    /// The faces at an edge, as ImprintNode::element has it; the second is -1 at the boundary.
    [[nodiscard]] std::array<int, 2> facesOfEdge(int edge) const;

private:
    struct Share {
        double share;  // on the edge; x in the face
        int node;
    };

    /// By edge or by face: nodes in order of their shares.
    class Lists {
    public:
        [[nodiscard]] std::span<const Share> at(int element) const;
        /// The first node of an element for which `isNear`, among those within `snap`; -1: none.
        template <class Near>
        [[nodiscard]] int find(int element, double share, double snap, const Near& isNear) const;
        void insert(int element, Share share);

    private:
        SparseMap<int> listOf_;
        std::vector<std::vector<Share>> lists_;
    };

    int addOnEdge(int face, int k, double share);
    int append(const ImprintNode& node, Lists& lists);
    [[nodiscard]] int edgeOf(int face, int k) const;
    [[nodiscard]] unsigned sidesOf(int node, int face) const;

    const Surface& surface_;
    const SnapDistances& snap_;
    std::vector<ImprintNode> nodes_;
    Lists onEdge_, inFace_;
};

}  // namespace bspline_curve
