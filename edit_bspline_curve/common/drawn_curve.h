// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/drawn_options.h"
#include "sketch/sketch.h"

#include <vector>

namespace bspline_curve {

/// A curve as layers keep it: what it is drawn from.
struct DrawnCurve {
    std::vector<SketchPick> picks;
    DrawnOptions options;
};

}  // namespace bspline_curve
