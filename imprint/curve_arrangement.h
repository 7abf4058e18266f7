// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "imprint/imprint_nodes.h"

#include <compare>
#include <map>
#include <set>
#include <vector>

namespace bspline_curve {

/// A straight piece of a curve in one face, between two nodes, a < b.
struct ImprintSegment {
    int a, b;

    auto operator<=>(const ImprintSegment&) const = default;
};

/// The segments of all curves, divided where they meet: after resolve() two segments of a face have
/// at most an end in common, no node lies on a segment or within the snapping distance of it, and
/// segments along a side are those between its neighbouring nodes. Snap rounding: a crossing
/// becomes a node, which may move by the snapping distance or by rounding, and the segments with
/// it; what they meet now is divided in turn (J. D. Hobby, Practical segment intersection with
/// finite precision output, 1999).
class CurveArrangement {
public:
    CurveArrangement(const Surface& surface, ImprintNodes& nodes, const SnapDistances& snap)
        : surface_(surface), nodes_(nodes), snap_(snap) {}

    /// Adds the segment of a curve between two nodes of a face.
    void add(int face, int from, int to);

    /// Divides. O(n log n + k) for n segments with k pairs whose boxes meet, in each face. Throws
    /// InputError (NoPath) where a face does not come to rest.
    void resolve();

    /// Faces with segments in their inside, ascending.
    [[nodiscard]] std::vector<int> faces() const;

    [[nodiscard]] bool hasSegmentsIn(int face) const { return segments_.contains(face); }

    /// The segments in the inside of a face that has some.
    [[nodiscard]] const std::set<ImprintSegment>& segmentsIn(int face) const {
        return segments_.at(face);
    }

    /// The nodes that a segment as it was added passes, in order, `from` left out.
    void appendPath(int face, int from, int to, std::vector<int>& path) const;

    /// The largest distance between a crossing and its node, in the user's unit.
    [[nodiscard]] double largestMove() const { return largestMove_; }

private:
    struct Placed;

    bool resolveFace(int face);
    bool divideAtNodes(int face, const std::vector<Placed>& segments);
    bool divideAtCrossings(int face, const std::vector<Placed>& segments);
    [[nodiscard]] std::vector<Placed> placed(int face) const;
    int addCrossing(int face, const Placed& one, const Placed& other);
    /// False where the node is an end of the segment.
    bool divide(int face, ImprintSegment segment, int node);
    void insert(int face, int a, int b);
    /// The node that divided a segment, or null.
    [[nodiscard]] const int* dividedAt(int face, ImprintSegment segment) const;
    [[nodiscard]] double distance(ImprintSegment segment, int node) const;

    const Surface& surface_;
    ImprintNodes& nodes_;
    const SnapDistances& snap_;
    std::map<int, std::set<ImprintSegment>> segments_;        // by face
    std::map<int, std::map<ImprintSegment, int>> divisions_;  // the node that divided a segment
    std::set<int> unresolved_;
    double largestMove_ = 0.0;
};

}  // namespace bspline_curve
