// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/nested_components.h"

#include <vector>

namespace bspline_curve {

/// A prism of a closed component whose tips above (slab 0) or below (1) have turned inside out.
struct EvertedPrism {
    int prism, slab;
};

/// Finds tips of closed components that have turned inside out as a whole, given that no boundaries
/// intersect: prisms overlap in them although every tetrahedron is positive. Then they enclose a
/// volume of another sign than the middles do, or hardly any. Arguments as in
/// findNestedComponents. O(n).
[[nodiscard]] std::vector<EvertedPrism> findEvertedLayers(
    const PillarLayers& layers,
    const std::vector<Prism>& prisms,
    const std::vector<Triangle>& faceNeighbours,
    const std::vector<char>& blocked
);

}  // namespace bspline_curve
