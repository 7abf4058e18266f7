// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/extended_surface.h"

#include <utility>
#include <vector>

namespace bspline_curve {

/// Edges by their ends, the lower one first, ascending.
using Edges = std::vector<std::pair<int, int>>;

/// Edges at which the surface turns sharply and which belong to a connected set of such edges as
/// long as a feature, not to roughness. O(n log n).
[[nodiscard]] Edges findCreases(const ExtendedSurface& extended);

/// The crease edges of the middle surface while it is being simplified: collapses move them.
class Creases {
public:
    Creases(Edges edges, int pillarCount);

    [[nodiscard]] bool holdEdge(int a, int b) const;

    /// Number of crease edges at a pillar.
    [[nodiscard]] int degree(int pillar) const { return degrees_[pillar]; }

    /// Pillar `removed`, which has two crease edges, goes into `kept` along one of them.
    void collapse(int removed, int kept);

private:
    Edges edges_;
    std::vector<int> degrees_;
};

}  // namespace bspline_curve
