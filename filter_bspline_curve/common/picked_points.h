// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "host_document.h"

#include <vector>

namespace bspline_curve {

/// The points that MeshLab's PickPoints tool left on a layer, in the order of picking, without
/// those marked as not present; in world coordinates. Empty where the tool was never used on the
/// layer.
[[nodiscard]] std::vector<Point3m> pickedPointsOf(const CMeshO& mesh);

}  // namespace bspline_curve
