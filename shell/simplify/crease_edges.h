// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/extended_surface.h"

#include <utility>
#include <vector>

namespace bspline_curve {

/// Edges (low vertex first, ascending) at which the surface turns sharply and which belong to a
/// connected set of such edges as long as a feature, not to roughness. O(n log n).
[[nodiscard]] std::vector<std::pair<int, int>> findCreases(const ExtendedSurface& extended);

}  // namespace bspline_curve
