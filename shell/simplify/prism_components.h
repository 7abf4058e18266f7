// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/shell.h"

#include <vector>

namespace bspline_curve {

/// Sets of prisms that are connected by walls.
struct PrismComponents {
    std::vector<int> componentOf;  ///< of each prism; -1 where blocked
    std::vector<int> first;        ///< a prism of each component
};

[[nodiscard]] PrismComponents findComponents(const std::vector<Prism>& prisms);

}  // namespace bspline_curve
