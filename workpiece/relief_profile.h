// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/imprint.h"
#include "bspline_curve/parts.h"
#include "bspline_curve/progress.h"

#include <vector>

namespace bspline_curve {

/// An imprint for a relief with a profile.
struct ProfiledImprint {
    Imprint imprint;             ///< with the same parts, and lines of equal height as edges
    std::vector<double> shares;  ///< for each vertex of its joined mesh that of the height, 0 to 1
};

/// Divides the parts `chosen` (labels, ascending) along lines at some distances from their rim, so
/// that a relief follows its profile to 0.5 % of its section, and gives each vertex its share of
/// the height. Heights of strokes go by the distance from their lines. Throws InputError
/// (BadOption: the width), Cancelled. As DistanceBeams and imprint().
[[nodiscard]] ProfiledImprint profiledImprint(
    const Imprint& imprint,
    const std::vector<int>& chosen,
    const CutChoice& choice,
    const Progress& progress = {}
);

}  // namespace bspline_curve
