// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/pillar_points.h"
#include "shell/prism_graph.h"

#include <vector>

namespace bspline_curve {

/// A half of a prism: slab 0 above the middle, slab 1 below it.
struct PrismSlab {
    int prism, slab;
};

/// Finds slabs that hold a point of another component, given that no boundaries intersect: then
/// bottom, middle and top of one pillar of each component stand for all of it. Exact. O(n) for one
/// component, O(n log c + hits) for c.
[[nodiscard]] std::vector<PrismSlab> findNestedSlabs(
    const PillarPoints& points, const std::vector<Prism>& prisms, const PrismComponents& components
);

/// Finds the slabs of closed components whose top or bottom is inside out as a whole, given that no
/// boundaries intersect: prisms overlap in them although every tetrahedron is positive. Such a
/// layer encloses a volume of another sign than the middle does, or hardly any. O(n).
[[nodiscard]] std::vector<PrismSlab> findInvertedSlabs(
    const PillarPoints& points, const std::vector<Prism>& prisms, const PrismComponents& components
);

}  // namespace bspline_curve
