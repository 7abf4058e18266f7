// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace bspline_curve {

/// An edge between two rows of a matrix, and how strongly it couples them.
struct CoupledRows {
    int from;
    int to;
    double weight;
};

/// An order for an incomplete factorisation of a matrix with so many rows, given the edges whose
/// weights are large: the rows of each tree of a spanning forest of the largest weights follow each
/// other, each before the one that it hangs on. So no two neighbours in the forest are left behind
/// when a row is eliminated, and nothing that is large fills in along it. Trees come in the order
/// of their last rows, as do rows without such edges: at the first ones, rows that are not in a
/// tree would often come after all of their neighbours. O(n + m log m).
[[nodiscard]] std::vector<int> eliminationOrder(int rowCount, std::vector<CoupledRows> edges);

}  // namespace bspline_curve
