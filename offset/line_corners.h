// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "offset/level_lines.h"

#include <vector>

namespace bspline_curve {

/// The smooth pieces of a line at a distance, cut at the corners where two parts of it ran into
/// each other: where it turns away from the curve by more than 20 degrees within 0.04 distances. A
/// closed line without corners stays closed; with corners each piece is open. O(n).
[[nodiscard]] std::vector<LevelLine> cutAtCorners(
    const Surface& surface, const LevelLine& line, double distance
);

}  // namespace bspline_curve
