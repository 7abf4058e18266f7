// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/surface.h"
#include "surface/travel_costs.h"
#include "utility/sparse_map.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <vector>

namespace bspline_curve {

/// The angle that the surface has at a vertex, radians: 2 pi in the plane.
[[nodiscard]] double totalAngle(const Surface& surface, int vertex);

/// Finds the strip of faces that the shortest path crosses, whatever the shape of the faces: where
/// a search over the midpoints of edges sees long zigzags, as across needles, this sees the
/// straight ways.
///
/// Windows are parts of edges that straight ways reach over the same faces; they are passed on from
/// face to face, the one with the least estimate of the whole way first (A*), and dropped where a
/// way over a vertex is shorter (Chen and Han 1990, with the filter of Xin and Wang 2009). Ways
/// bend at vertices with more than 2 pi of angle and at rims. Exact up to rounding. Memory is kept
/// for the next search.
class WindowSearch {
public:
    /// All open faces count alike: costs are lengths. Refers to both.
    WindowSearch(const Surface& surface, KnownCosts& costs) : surface_(surface), costs_(costs) {}

    /// The strip of the shortest path from a start to a goal in other faces. Nothing if no path is
    /// shorter than `longest`. Where `mostWindows` do not suffice to tell, that of the shortest
    /// path found so far. The work grows with the faces that paths shorter than `longest` can meet.
    [[nodiscard]] std::optional<std::vector<int>> find(
        const SurfacePoint& start, const SurfacePoint& goal, double longest, std::size_t mostWindows
    );

    /// How many windows the last search has passed on.
    [[nodiscard]] std::size_t explored() const { return windows_.size(); }

private:
    using Vec2 = Eigen::Vector2d;

    // A crossing 3 f + k leaves face f over the edge opposite to its corner k. In the plane of f
    // that edge runs along the x axis from corner k + 1 at the origin; f lies above it.
    struct Window {
        int crossing;
        double begin, end;  // along the edge
        double width;       // of the edge
        Vec2 source;        // where the ways come from straight: the start or a vertex
        double before;      // length of the way to there
        int parent;         // the window before, kAtStart or, of vertex v, fromVertex(v)
    };

    // The shortest way to a vertex that is known.
    struct Arrival {
        double length;
        int parent;  // as of windows; of a vertex: along the edge from it
    };

    static constexpr int kAtStart = -1;

    static constexpr int fromVertex(int vertex) { return -2 - vertex; }

    static constexpr int vertexOf(int parent) { return -2 - parent; }

    // An edge as a window over it sees it, and the face behind.
    struct Gate {
        int right, left, apex;            // vertices: at the origin, at (width, 0), behind
        int overRightSide, overLeftSide;  // crossings from right to apex, and from apex to left
        int face;                         // behind
        double width;
        Vec2 apexAt;  // below the x axis
    };

    // Of an edge of a face, seen along a way out of the face: over which of the two other edges the
    // way came in.
    enum class Side : char { None, Right, Left };

    void leaveStart(const SurfacePoint& start);
    [[nodiscard]] int faceBehind(int crossing) const;
    [[nodiscard]] Gate gateOf(int crossing) const;
    [[nodiscard]] double lengthTo(int vertex) const;
    void reach(int vertex, double length, int parent);
    void radiate(int crossing, const Vec3& from, double before, int parent);
    void add(const Window& window, Side side);
    void pass(int index);
    void arrive(double length, int parent, int face);
    void leave(int vertex);
    [[nodiscard]] bool bendsWays(int vertex);
    [[nodiscard]] std::optional<std::vector<int>> strip();
    [[nodiscard]] bool turnAt(int vertex, const std::vector<int>& faces, std::vector<int>& strip);

    const Surface& surface_;
    KnownCosts& costs_;
    std::vector<int> startFaces_, goalFaces_;
    Vec3 goal_ = Vec3::Zero();
    double shortest_ = 0.0;  // of whole ways, or the limit
    int goalParent_ = kAtStart, goalFace_ = -1;
    std::vector<Window> windows_;
    SparseMap<Arrival> arrivals_;
    OfferQueue queue_;
};

}  // namespace bspline_curve
