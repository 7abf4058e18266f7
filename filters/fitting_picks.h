// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "imprint/projected_polyline.h"

#include <vector>

namespace bspline_curve {

/// Vertices of a polyline, ascending, by which it is described: the polyline through them alone is
/// within a tolerance of all others (D. Douglas, T. Peucker, 1973). Both ends of an open one; of a
/// closed one at least three, where it has as many. Vertices that lie on each other count once.
/// O(n log n) on most polylines.
[[nodiscard]] std::vector<int> fittingPicks(const SpacePolyline& line, double tolerance);

}  // namespace bspline_curve
