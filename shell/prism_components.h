// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/shell.h"

#include <vector>

namespace bspline_curve {

/// The components of a shell: prisms that are joined across walls.
struct PrismComponents {
    std::vector<int> componentOf;  ///< of each prism; -1 where blocked
    std::vector<int> first;        ///< the first prism of each component
    std::vector<char> isClosed;    ///< no wall of the component is an end of the shell

    [[nodiscard]] int count() const { return static_cast<int>(first.size()); }
};

/// Of a finished shell. O(n).
[[nodiscard]] PrismComponents findComponents(const std::vector<Prism>& prisms);

/// Of one under construction: `faceNeighbours` as in ExtendedSurface; where `blocked` is not zero
/// there is no prism. O(n).
[[nodiscard]] PrismComponents findComponents(
    const std::vector<Triangle>& faceNeighbours, const std::vector<char>& blocked
);

}  // namespace bspline_curve
