// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/energy.h"

#include <vector>

namespace bspline_curve {

/// Breaks with the marked spans halved, but for those whose halves would be shorter than
/// `minimumSpan`.
[[nodiscard]] std::vector<double> halveSpans(
    const SplineSpace& space, const std::vector<char>& marked, double minimumSpan
);

/// Breaks with the spans halved that together promise most of the gain, largest first.
[[nodiscard]] std::vector<double> halveLargest(
    const SplineSpace& space, const KnotDemand& gain, double minimumSpan
);

}  // namespace bspline_curve
