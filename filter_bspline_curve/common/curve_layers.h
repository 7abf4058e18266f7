// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filter_bspline_curve/common/layer_arrays.h"
#include "filters/imprint_requests.h"
#include "filters/polyline_layers.h"
#include "host_document.h"

namespace bspline_curve {

/// The surface and the layers of curves that a filter is to use: the one that is named or, where
/// that is the surface itself, all visible layers of polylines; those that go with a curve, as its
/// control polygon, are no curves. Takes the input out of the arrays. Throws InputError where a
/// named layer is not there or has no polyline.
[[nodiscard]] CurvesOnLayer curvesOnLayer(
    const MeshDocument& document,
    const MeshModel& surface,
    const LayerArrays& arrays,
    const CurveUse& use
);

}  // namespace bspline_curve
