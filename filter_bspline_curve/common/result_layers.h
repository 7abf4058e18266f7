// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filter_bspline_curve/common/layer_arrays.h"
#include "filters/requests.h"
#include "filters/run_filters.h"

namespace bspline_curve {

/// Adds a layer with the curve and makes it the current one: vertices in order with edges between
/// them, in the coordinates of the surface's layer and under its matrix, so that both stay
/// together. Per vertex: quality (the field or, where there is none, the spline's parameter t), the
/// surface's normal, colour, and the custom attributes face_index (in the surface's layer),
/// barycentric, t. After it come the layers that the request asked for besides: "… tube", "…
/// control polygon", "… shell top" and "… shell bottom", likewise in the surface's coordinates.
/// The curve's layer keeps what it was drawn from, see CurveSource.
void addResultLayers(
    MeshDocument& document,
    const MeshModel& surface,
    const LayerArrays& arrays,
    const CurveRequest& request,
    const CurveResult& result
);

/// Makes a field the quality of its layer.
void setQuality(MeshModel& layer, const LayerArrays& arrays, const FieldResult& result);

}  // namespace bspline_curve
