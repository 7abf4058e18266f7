// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <vector>

namespace bspline_curve {

/// A hierarchy of boxes for the checks: which of many boxes overlap a given one.
class BoxTree {
public:
    using Box = Eigen::AlignedBox3d;

    /// O(n log n).
    explicit BoxTree(std::vector<Box> boxes);

    /// Calls visit(i) for every box i that overlaps `query` (touching counts), in an order of its
    /// own.
    template <class Visitor>
    void forEachOverlapping(const Box& query, const Visitor& visit) const {
        if (nodes_.empty()) {
            return;
        }
        // Halving ranges of ints: 31 levels at most, one sibling pending at each.
        std::array<std::size_t, 64> pending{};
        std::size_t pendingCount = 1;
        while (pendingCount > 0) {
            const std::size_t index = pending[--pendingCount];
            const Node& node = nodes_[index];
            if (!node.box.intersects(query)) {
                continue;
            }
            if (node.last - node.first <= kLeafSize) {
                for (std::size_t i = node.first; i < node.last; ++i) {
                    if (boxes_[order_[i]].intersects(query)) {
                        visit(order_[i]);
                    }
                }
            } else {
                pending[pendingCount++] = node.right;
                pending[pendingCount++] = index + 1;
            }
        }
    }

private:
    static constexpr std::size_t kLeafSize = 8;

    struct Node {
        Box box;
        std::size_t first, last;  ///< range of order_
        std::size_t right;        ///< second child; the first one follows the node
    };

    std::size_t build(std::size_t first, std::size_t last);

    std::vector<Box> boxes_;
    std::vector<int> order_;
    std::vector<Node> nodes_;
};

}  // namespace bspline_curve
