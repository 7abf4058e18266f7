// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/shell.h"

#include <vector>

namespace bspline_curve {

/// The prism over a face, whose pillars are numbered like its vertices: slots ascending by vertex.
/// Without neighbours.
[[nodiscard]] Prism prismOver(const Triangle& face);

/// Joins prisms over neighbouring faces across their walls, but for those whose orientation is 0
/// (blocked). Prism i lies over face i; `faceNeighbours` as in ExtendedSurface. O(n).
void connectPrisms(std::vector<Prism>& prisms, const std::vector<Triangle>& faceNeighbours);

/// Joins prisms that have the two pillars of a wall in common. O(n log n).
void connectPrisms(std::vector<Prism>& prisms);

/// The components of a shell: prisms that are joined across walls.
struct PrismComponents {
    std::vector<int> componentOf;  ///< of each prism; -1 where blocked
    std::vector<int> first;        ///< the first prism of each component
    std::vector<char> isClosed;    ///< no wall of the component is an end of the shell

    [[nodiscard]] int count() const { return static_cast<int>(first.size()); }
};

/// Blocked prisms (orientation 0) may still be named as neighbours. O(n).
[[nodiscard]] PrismComponents findComponents(const std::vector<Prism>& prisms);

}  // namespace bspline_curve
