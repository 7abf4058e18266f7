// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filter_bspline_curve/common/layer_arrays.h"
#include "filters/drawn_curve.h"

#include <optional>

namespace bspline_curve {

/// The curve of a layer, on the arrays of its surface; none where the layer is no curve of ours,
/// where its picks are no longer on the surface, or where it was drawn with options that the tool
/// does not offer (see drawnOptions()).
[[nodiscard]] std::optional<DrawnCurve> reopened(
    const MeshModel& layer, const MeshModel& surface, const LayerArrays& arrays
);

}  // namespace bspline_curve
