// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/progress.h"
#include "filters/fit_requests.h"
#include "filters/run_filters.h"
#include "filters/workpiece_cache.h"

#include <span>
#include <vector>

namespace bspline_curve {

struct FitResult {
    /// One for each boundary that has a smooth curve so near, with the request that would draw it
    /// through its picks.
    struct FittedCurve {
        CurveRequest request;
        CurveResult result;
    };

    std::vector<FittedCurve> curves;
    Figures figures;
    FilterLog log;
};

/// Smooth curves along the boundaries between faces of different labels, each once and from
/// junction to junction. `labels`: of the faces of the layer. Throws InputError where there is no
/// boundary, or no curve so near to any; Cancelled, std::bad_alloc.
[[nodiscard]] FitResult runFitFilter(
    const LayerInput& layer,
    std::span<const int> labels,
    const FitRequest& request,
    WorkpieceCache& workpieces,
    const Progress& progress = {}
);

}  // namespace bspline_curve
