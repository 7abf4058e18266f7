// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "imprint/imprint_nodes.h"
#include "utility/sparse_map.h"

#include <compare>
#include <span>
#include <utility>
#include <vector>

namespace bspline_curve {

/// A straight piece of a curve in one face, between two nodes, a < b.
struct ImprintSegment {
    int a, b;

    auto operator<=>(const ImprintSegment&) const = default;
};

/// The segments of all curves, divided where they meet: after resolve() two segments of a face have
/// at most an end in common, no node lies on a segment or within the snapping distance of it (but
/// where it is farther from one end than the other is), and segments along a side are those between
/// its neighbouring nodes. Snap rounding: a crossing becomes a node, which may move by the snapping
/// distance or by rounding, and the segments with it; what they meet now is divided in turn (J. D.
/// Hobby, Practical segment intersection with finite precision output, 1999).
class CurveArrangement {
public:
    CurveArrangement(const Surface& surface, ImprintNodes& nodes, const SnapDistances& snap)
        : surface_(surface), nodes_(nodes), snap_(snap) {}

    /// Adds the segment of a curve between two nodes of a face.
    void add(int face, int from, int to) { insert(face, from, to); }

    /// Divides. O(n log n + k) for n segments with k pairs whose boxes meet, in each face. Throws
    /// InputError (NoPath) where a face does not come to rest, or would divide in a circle.
    void resolve();

    /// Faces with segments in their inside, in no order.
    [[nodiscard]] std::vector<int> faces() const;
    /// The segments in the inside of a face, ascending.
    [[nodiscard]] std::span<const ImprintSegment> segmentsIn(int face) const;

    /// The nodes that a segment as it was added passes, in order, `from` left out.
    void appendPath(int face, int from, int to, std::vector<int>& path) const;

    /// The largest distance that a segment or crossing was moved, in the user's unit.
    [[nodiscard]] double largestMove() const { return largestMove_; }

private:
    struct Placed {
        ImprintSegment segment;
        FacePlace a, b;

        [[nodiscard]] double low() const { return std::min(a.x(), b.x()); }

        [[nodiscard]] double high() const { return std::max(a.x(), b.x()); }

        [[nodiscard]] bool passes(const FacePlace& place, double snap) const;
        [[nodiscard]] bool crosses(const Placed& other) const;
        [[nodiscard]] FacePlace crossing(const Placed& other) const;
    };

    struct PlacedNode {
        FacePlace place;
        int node;
    };

    struct FaceSegments {
        int face = -1;
        bool isResolved = false;
        std::vector<ImprintSegment> segments{};                   // ascending
        std::vector<std::pair<ImprintSegment, int>> divisions{};  // segments with their nodes
    };

    bool resolveFace(int face);
    void placeAll(int face);
    bool divideAtNodes(int face);
    bool divideAtCrossings(int face);
    int addCrossing(int face, const Placed& one, const Placed& other);
    /// False where the node is an end of the segment.
    bool divide(int face, ImprintSegment segment, int node);
    void insert(int face, int a, int b);
    /// The node that divided a segment, or null.
    [[nodiscard]] const int* dividedAt(int face, ImprintSegment segment) const;
    /// Whether one of the pieces that a segment has been divided into is, or was, the other.
    [[nodiscard]] bool passesAlong(int face, ImprintSegment whole, ImprintSegment part) const;
    [[nodiscard]] double distance(ImprintSegment segment, int node) const;

    const Surface& surface_;
    ImprintNodes& nodes_;
    const SnapDistances& snap_;
    SparseMap<int> slotOf_;  // by face
    std::vector<FaceSegments> slots_;
    double largestMove_ = 0.0;
    // Of the face at hand; kept for their memory.
    std::vector<Placed> placed_;
    std::vector<PlacedNode> placedNodes_;
    std::vector<int> listed_;
};

}  // namespace bspline_curve
