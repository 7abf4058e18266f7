// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/progress.h"
#include "filters/pattern_requests.h"
#include "filters/polyline_layers.h"
#include "filters/run_filters.h"
#include "filters/workpiece_cache.h"
#include "pattern/carried_drawing.h"

#include <vector>

namespace bspline_curve {

struct PatternResult {
    std::vector<PatternCurve> curves;  ///< all, along one curve after the other
    Figures figures;
    FilterLog log;
};

/// A drawing as curves on a layer. `input.curves` are for PatternPlace::Curve alone; `toolPoints`:
/// see patternCentre(). Throws InputError, Cancelled, std::bad_alloc; see describeFailure().
[[nodiscard]] PatternResult runPatternFilter(
    const CurvesOnLayer& input,
    const std::vector<Vec3>& toolPoints,
    const PatternRequest& request,
    WorkpieceCache& workpieces,
    const Progress& progress = {}
);

}  // namespace bspline_curve
