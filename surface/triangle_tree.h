// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"
#include "bspline_curve/progress.h"
#include "surface/spatial_order.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace bspline_curve {

/// A hierarchy of axis-aligned boxes over triangles, for closest points and for pairs of triangles
/// that may intersect. Keeps a copy of nothing but the boxes; the arrays must outlive it.
/// About 50 bytes per triangle.
class TriangleTree {
public:
    /// Expects finite coordinates and valid indices; triangles without area are allowed.
    /// O(n log n). The result is the same on every platform (ties broken by index). Throws
    /// Cancelled.
    TriangleTree(
        const std::vector<Vec3>& vertices,
        const std::vector<Triangle>& triangles,
        const Progress& progress = {}
    );

    struct Closest {
        SurfacePoint point;  ///< face -1 where there is none
        Vec3 position = Vec3::Zero();
        double squaredDistance = 0.0;
    };

    /// The closest point of all triangles; of several equally close triangles the one with the
    /// lowest index. Accurate to rounding (see closestPointOnTriangle); coordinates beyond 1e150
    /// count as that, and so does the distance. O(log n) near the surface.
    /// `within`: there is none where all triangles are as far away as that; soon known.
    [[nodiscard]] Closest closestPoint(
        const Vec3& query, double within = std::numeric_limits<double>::infinity()
    ) const;

    /// Calls visit(j) for every triangle whose box overlaps the cube of points that differ from
    /// this one by at most `reach` in each coordinate. The order is the same on every platform.
    /// O(log n) where few do.
    template <class Visitor>
    void forEachNear(const Vec3& point, double reach, const Visitor& visit) const;

    struct Hit {
        SurfacePoint point;  ///< face -1 where nothing is hit
        Vec3 position = Vec3::Zero();
        double distance = 0.0;  ///< along the ray, in lengths of its direction
    };

    /// The first triangle, from either side, that a ray meets; of several as near the one with the
    /// lowest index. No ray slips through between triangles that share an edge or a vertex
    /// (S. Woop, C. Benthin, I. Wald, Watertight Ray/Triangle Intersection, 2013). The direction
    /// need not be of unit length; nothing is hit where it is zero. O(log n) on most meshes.
    [[nodiscard]] Hit firstHit(const Vec3& origin, const Vec3& direction) const;

    /// Calls visit(i, j), i < j, once for every pair of triangles whose boxes overlap (touching
    /// counts). The order is the same on every platform.
    template <class Visitor>
    void forEachOverlappingPair(const Visitor& visit) const;

    /// Calls visit(j) for every triangle whose box overlaps that of a triangle (touching counts),
    /// this one included. The order is the same on every platform. O(log n) where few do.
    template <class Visitor>
    void forEachOverlapping(int triangle, const Visitor& visit) const;

    /// Whether test(j) holds for some triangle whose box overlaps that of a triangle, given by its
    /// corners, and is not wholly on one side of its plane. O(log n) where few are, also for a
    /// large triangle in the middle of a mesh.
    template <class Test>
    [[nodiscard]] bool anyMeeting(const std::array<Vec3, 3>& corners, const Test& test) const;

private:
    static constexpr int kLeafSize = 4;
    /// Nodes that wait in a search, at most. Depth: at most one level per Morton bit (63) and per
    /// halving of equal codes (31); each level leaves one sibling pending.
    static constexpr std::size_t kStackSize = 128;

    struct Box {
        Vec3 low, high;

        [[nodiscard]] bool overlaps(const Box& other) const {
            return low[0] <= other.high[0] && other.low[0] <= high[0] && low[1] <= other.high[1] &&
                   other.low[1] <= high[1] && low[2] <= other.high[2] && other.low[2] <= high[2];
        }

        void extend(const Box& other) {
            low = low.cwiseMin(other.low);
            high = high.cwiseMax(other.high);
        }
    };

    /// Nodes are in depth-first order: the left child of an inner node follows it.
    struct Node {
        Box box;
        int first = 0, count = 0;  ///< leaf: range of order_; inner: count 0, first = right child

        [[nodiscard]] bool isLeaf() const { return count > 0; }
    };

    struct ClosestSearch;
    struct RaySearch;

    [[nodiscard]] static std::size_t middleOf(
        const std::vector<MortonKey>& keys, std::size_t first, std::size_t last
    );
    [[nodiscard]] static std::size_t nodeCount(
        const std::vector<MortonKey>& keys, std::size_t first, std::size_t last
    );
    int build(const std::vector<MortonKey>& keys, std::size_t first, std::size_t last);

    [[nodiscard]] const Node& node(int i) const { return nodes_[i]; }

    [[nodiscard]] Box boxOf(int triangle) const {
        const Triangle& corners = triangles_[triangle];
        const Vec3& a = vertices_[corners[0]];
        const Vec3& b = vertices_[corners[1]];
        const Vec3& c = vertices_[corners[2]];
        return {a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
    }

    template <class Visitor>
    void forEachOverlapping(const Box& box, const Visitor& visit) const {
        forEachWhere([&](const Box& other) { return other.overlaps(box); }, visit);
    }

    /// Calls visit(j) for every triangle whose box may be met; so may all boxes around it then.
    template <class Test, class Visitor>
    void forEachWhere(const Test& mayMeet, const Visitor& visit) const;

    template <class Visitor>
    void visitLeafPair(int a, int b, const Visitor& visit) const;

    const std::vector<Vec3>& vertices_;
    const std::vector<Triangle>& triangles_;
    std::vector<int> order_;
    std::vector<Node> nodes_;
};

template <class Visitor>
void TriangleTree::forEachOverlappingPair(const Visitor& visit) const {
    if (nodes_.empty()) {
        return;
    }

    // A pair of nodes whose triangles are still to be compared; a == b: those of one node.
    struct NodePair {
        int a, b;
    };

    std::vector<NodePair> pending{{0, 0}};
    const auto push = [&](int a, int b) {
        if (node(a).box.overlaps(node(b).box)) {
            pending.push_back({a, b});
        }
    };
    while (!pending.empty()) {
        const auto [a, b] = pending.back();
        pending.pop_back();
        if (node(a).isLeaf() && node(b).isLeaf()) {
            visitLeafPair(a, b, visit);
        } else if (a == b) {
            const int left = a + 1;
            const int right = node(a).first;
            push(left, right);
            pending.push_back({right, right});
            pending.push_back({left, left});
        } else {
            // Open the larger one of the two.
            const auto squaredSize = [&](int i) {
                return (node(i).box.high - node(i).box.low).squaredNorm();
            };
            const bool openA =
                node(b).isLeaf() || (!node(a).isLeaf() && squaredSize(a) >= squaredSize(b));
            const int opened = openA ? a : b;
            const int kept = openA ? b : a;
            push(node(opened).first, kept);
            push(opened + 1, kept);
        }
    }
}

template <class Visitor>
void TriangleTree::forEachOverlapping(int triangle, const Visitor& visit) const {
    forEachOverlapping(boxOf(triangle), visit);
}

template <class Visitor>
void TriangleTree::forEachNear(const Vec3& point, double reach, const Visitor& visit) const {
    if (!nodes_.empty()) {
        forEachOverlapping(Box{point.array() - reach, point.array() + reach}, visit);
    }
}

template <class Test>
bool TriangleTree::anyMeeting(const std::array<Vec3, 3>& corners, const Test& test) const {
    /// Beyond what rounding does to the distance from a plane, relative to its terms.
    constexpr double kPlaneRounding = 1e-14;
    const auto& [a, b, c] = corners;
    const Box box{a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
    const Vec3 normal = (b - a).cross(c - a);
    const double slack = kPlaneRounding * (b - a).norm() * (c - a).norm();
    bool isFound = false;
    const auto mayMeet = [&](const Box& other) {
        if (isFound || !other.overlaps(box)) {
            return false;
        }
        const Vec3 middle = 0.5 * (other.low + other.high);
        const Vec3 half = 0.5 * (other.high - other.low);
        const double terms = middle.cwiseAbs().sum() + half.sum() + a.cwiseAbs().sum();
        return std::abs(normal.dot(middle - a)) <= normal.cwiseAbs().dot(half) + slack * terms;
    };
    if (!nodes_.empty()) {
        forEachWhere(mayMeet, [&](int j) { isFound = test(j); });
    }
    return isFound;
}

template <class Test, class Visitor>
void TriangleTree::forEachWhere(const Test& mayMeet, const Visitor& visit) const {
    std::array<int, kStackSize> stack;
    std::size_t stackSize = 0;
    stack[stackSize++] = 0;
    while (stackSize > 0) {
        const int here = stack[--stackSize];
        if (!mayMeet(node(here).box)) {
            continue;
        }
        if (!node(here).isLeaf()) {
            stack[stackSize++] = node(here).first;
            stack[stackSize++] = here + 1;
            continue;
        }
        for (int i = node(here).first; i < node(here).first + node(here).count; ++i) {
            const int other = order_[i];
            if (mayMeet(boxOf(other))) {
                visit(other);
            }
        }
    }
}

template <class Visitor>
void TriangleTree::visitLeafPair(int a, int b, const Visitor& visit) const {
    const int countA = node(a).count;
    const int countB = node(b).count;
    const int* const trianglesA = order_.data() + node(a).first;
    const int* const trianglesB = order_.data() + node(b).first;
    std::array<Box, kLeafSize> boxesB;
    for (int j = 0; j < countB; ++j) {
        boxesB[j] = boxOf(trianglesB[j]);
    }
    for (int i = 0; i < countA; ++i) {
        const Box boxA = boxOf(trianglesA[i]);
        for (int j = a == b ? i + 1 : 0; j < countB; ++j) {
            if (boxA.overlaps(boxesB[j])) {
                visit(
                    std::min(trianglesA[i], trianglesB[j]), std::max(trianglesA[i], trianglesB[j])
                );
            }
        }
    }
}

}  // namespace bspline_curve
