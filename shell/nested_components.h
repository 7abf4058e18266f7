// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/shell.h"

#include <cstddef>
#include <vector>

namespace bspline_curve {

/// Pillars of a shell under construction: layers of points, one for each pillar; tips above and
/// below (layers 0, 1) and middles (2).
struct PillarLayers {
    std::vector<Vec3> points;  ///< layer by layer
    std::size_t pillarCount = 0;

    [[nodiscard]] std::size_t indexOf(std::size_t layer, std::size_t pillar) const {
        return layer * pillarCount + pillar;
    }

    [[nodiscard]] const Vec3& point(std::size_t layer, std::size_t pillar) const {
        return points[indexOf(layer, pillar)];
    }
};

/// A vertex of one component of the shell whose middle or one of its tips lies in a slab (0 above,
/// 1 below) of another one.
struct NestedVertex {
    int vertex, prism, slab;
};

/// Finds components inside of others, or overlapping them, given that no boundaries intersect: then
/// middle and tips of one vertex of each component stand for all. `faceNeighbours` as in
/// ExtendedSurface; prisms with a nonzero `blocked` are left out. Exact. O(n) for one component,
/// O(n log c + hits) for c.
[[nodiscard]] std::vector<NestedVertex> findNestedComponents(
    const PillarLayers& layers,
    const std::vector<Prism>& prisms,
    const std::vector<Triangle>& faceNeighbours,
    const std::vector<char>& blocked
);

}  // namespace bspline_curve
