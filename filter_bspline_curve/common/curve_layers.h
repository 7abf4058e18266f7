// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filter_bspline_curve/common/layer_arrays.h"
#include "filters/imprint_requests.h"
#include "filters/polyline_layers.h"
#include "host_document.h"

#include <vector>

namespace bspline_curve {

/// The layers of curves that a filter is to use: the one that is named or, where that is the
/// surface itself, all visible polylines that were drawn on it or on no layer that is there.
/// Results of such filters (isResult()) are meant only where there are no others, and curves of
/// other surfaces only where there are no results either; those that go with a curve, as its
/// control polygon, never. Polylines that were not drawn on the surface are optional. Throws
/// InputError where a named layer is not there or has no polyline.
[[nodiscard]] std::vector<PolylineLayer> curvesFor(
    const MeshDocument& document,
    const MeshModel& surface,
    const LayerArrays& arrays,
    const CurveUse& use
);

}  // namespace bspline_curve
