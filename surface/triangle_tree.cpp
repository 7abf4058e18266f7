// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/triangle_tree.h"

#include "bspline_curve/progress.h"
#include "surface/closest_point.h"
#include "surface/spatial_order.h"
#include "utility/large_array.h"

#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace bspline_curve {

TriangleTree::TriangleTree(
    const std::vector<Vec3>& vertices,
    const std::vector<Triangle>& triangles,
    const Progress& progress
)
    : vertices_(vertices), triangles_(triangles) {
    if (triangles.empty()) {
        return;
    }
    const std::vector<MortonKey> keys = spatialOrder(triangles.size(), [&](std::size_t i) -> Vec3 {
        const Box box = boxOf(static_cast<int>(i));
        return 0.5 * box.low + 0.5 * box.high;
    });
    report(progress, 0.5, kPreparingStage);
    reserveLarge(order_, keys.size());
    for (const MortonKey& key : keys) {
        order_.push_back(key.index);
    }
    reserveLarge(nodes_, nodeCount(keys, 0, keys.size()));
    build(keys, 0, keys.size());
}

/// Where a range of the order is cut in two. Where the highest bit changes that the range does not
/// share: that halves a cell of space. Equal codes are halved by number.
std::size_t TriangleTree::middleOf(
    const std::vector<MortonKey>& keys, std::size_t first, std::size_t last
) {
    const std::uint64_t difference = keys[first].code ^ keys[last - 1].code;
    if (difference == 0) {
        return first + (last - first) / 2;
    }
    const std::uint64_t bit = std::bit_floor(difference);
    const auto split = std::partition_point(
        keys.begin() + static_cast<std::ptrdiff_t>(first),
        keys.begin() + static_cast<std::ptrdiff_t>(last),
        [bit](const MortonKey& key) { return (key.code & bit) == 0; }
    );
    return static_cast<std::size_t>(split - keys.begin());
}

/// Number of nodes of the subtree of a range.
std::size_t TriangleTree::nodeCount(
    const std::vector<MortonKey>& keys, std::size_t first, std::size_t last
) {
    if (last - first <= kLeafSize) {
        return 1;
    }
    const std::size_t middle = middleOf(keys, first, last);
    return 1 + nodeCount(keys, first, middle) + nodeCount(keys, middle, last);
}

/// Builds the subtree of a range of the order; returns its root.
int TriangleTree::build(const std::vector<MortonKey>& keys, std::size_t first, std::size_t last) {
    const std::size_t index = nodes_.size();
    nodes_.emplace_back();
    if (last - first <= kLeafSize) {
        Box box = boxOf(order_[first]);
        for (std::size_t i = first + 1; i < last; ++i) {
            box.extend(boxOf(order_[i]));
        }
        nodes_[index] = {
            .box = box,
            .first = static_cast<int>(first),
            .count = static_cast<int>(last - first),
        };
        return static_cast<int>(index);
    }

    const std::size_t middle = middleOf(keys, first, last);
    const int left = build(keys, first, middle);
    const int right = build(keys, middle, last);
    Box box = node(left).box;
    box.extend(node(right).box);
    nodes_[index] = {.box = box, .first = right, .count = 0};
    return static_cast<int>(index);
}

/// One search for the closest point, nearest boxes first.
struct TriangleTree::ClosestSearch {
    const TriangleTree& tree;
    const Vec3& query;
    Closest best;
    /// Boxes farther than the limit are skipped. It exceeds the best distance by the slack, more
    /// than the rounding of positions, so that what is skipped never decides a tie.
    double slack;
    double squaredLimit;

    ClosestSearch(const TriangleTree& searched, const Vec3& point, double within)
        : tree(searched), query(point) {
        constexpr double kPositionRounding = 16.0 * std::numeric_limits<double>::epsilon();
        const Box& whole = tree.node(0).box;
        slack =
            kPositionRounding * (whole.low.cwiseAbs().maxCoeff() +
                                 whole.high.cwiseAbs().maxCoeff() + query.cwiseAbs().maxCoeff());
        lower(within * within);
    }

    void lower(double squaredDistance) {
        best.squaredDistance = squaredDistance;
        const double limit = std::sqrt(squaredDistance) + slack;
        squaredLimit = limit * limit;
    }

    [[nodiscard]] double squaredDistanceTo(const Box& box) const {
        return (box.low - query).cwiseMax(query - box.high).cwiseMax(0.0).squaredNorm();
    }

    void visitLeaf(const Node& leaf) {
        for (int i = leaf.first; i < leaf.first + leaf.count; ++i) {
            const int triangle = tree.order_[i];
            const ClosestPointOnTriangle candidate =
                closestPointOnTriangle(tree.vertices_, tree.triangles_[triangle], query);
            if (candidate.squaredDistance < best.squaredDistance ||
                (candidate.squaredDistance == best.squaredDistance && triangle < best.point.face)) {
                best.point = {.face = triangle, .barycentric = candidate.barycentric};
                best.position = candidate.position;
                lower(candidate.squaredDistance);
            }
        }
    }

    void run() {
        struct Pending {
            int node;
            double squaredDistance;
        };

        std::array<Pending, kStackSize> stack;
        std::size_t stackSize = 0;
        const auto pending = [&](int i) {
            return Pending{.node = i, .squaredDistance = squaredDistanceTo(tree.node(i).box)};
        };
        stack[stackSize++] = pending(0);
        while (stackSize > 0) {
            const Pending current = stack[--stackSize];
            if (current.squaredDistance > squaredLimit) {
                continue;
            }
            const Node& here = tree.node(current.node);
            if (here.isLeaf()) {
                visitLeaf(here);
                continue;
            }
            Pending nearer = pending(current.node + 1);
            Pending farther = pending(here.first);
            if (farther.squaredDistance < nearer.squaredDistance) {
                std::swap(nearer, farther);
            }
            stack[stackSize++] = farther;
            stack[stackSize++] = nearer;
        }
    }
};

TriangleTree::Closest TriangleTree::closestPoint(const Vec3& query, double within) const {
    if (nodes_.empty()) {
        return {};
    }
    // Squares of larger differences overflow, and no triangle would be the closest one.
    constexpr double kFarthest = 1e150;
    const Vec3 near = query.cwiseMax(-kFarthest).cwiseMin(kFarthest);
    ClosestSearch search(*this, near, within);
    search.run();
    return search.best;
}

}  // namespace bspline_curve
