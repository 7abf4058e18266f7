// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filter_bspline_curve/common/layer_arrays.h"
#include "filters/fit_requests.h"

#include <vector>

namespace bspline_curve {

/// The labels of the faces of a layer's arrays. Throws InputError where the layer has nothing that
/// these are taken from, or a quality is not finite.
[[nodiscard]] std::vector<int> faceLabels(
    const MeshModel& layer, const LayerArrays& arrays, FaceLabels labels
);

}  // namespace bspline_curve
