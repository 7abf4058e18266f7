// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/check/box_tree.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace bspline_curve {

BoxTree::BoxTree(std::vector<Box> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
    std::iota(order_.begin(), order_.end(), 0);
    if (!boxes_.empty()) {
        build(0, boxes_.size());
    }
}

std::size_t BoxTree::build(std::size_t first, std::size_t last) {
    const std::size_t index = nodes_.size();
    Box box;
    Box centres;
    for (std::size_t i = first; i < last; ++i) {
        const Box& item = boxes_[order_[i]];
        box.extend(item);
        centres.extend(item.center());
    }
    nodes_.push_back({box, first, last, 0});
    if (last - first > kLeafSize) {
        // Halve the boxes along the axis on which their centres spread most.
        Eigen::Index axis = 0;
        centres.sizes().maxCoeff(&axis);
        const std::size_t middle = first + (last - first) / 2;
        const auto position = [this](std::size_t i) {
            return order_.begin() + static_cast<std::ptrdiff_t>(i);
        };
        std::nth_element(position(first), position(middle), position(last), [&](int a, int b) {
            const auto key = [&](int i) { return std::pair(boxes_[i].center()[axis], i); };
            return key(a) < key(b);
        });
        build(first, middle);
        const std::size_t right = build(middle, last);
        nodes_[index].right = right;
    }
    return index;
}

}  // namespace bspline_curve
