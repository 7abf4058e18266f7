// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filter_bspline_curve/common/layer_arrays.h"
#include "filters/requests.h"
#include "filters/run_filters.h"
#include "host_document.h"

namespace bspline_curve {

/// Adds the layers of a result, see addResultLayers(). In a window the surface stays the current
/// layer, where the next points are picked, and where the request asks for it, the curve whose
/// picks were moved goes, see curveOfPicks().
void showCurve(
    MeshDocument& document,
    const MeshModel& surface,
    const LayerArrays& arrays,
    const CurveRequest& request,
    const CurveResult& result
);

}  // namespace bspline_curve
