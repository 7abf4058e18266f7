// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/options.h"
#include "design/initial_path.h"
#include "solver/faired_shape.h"

namespace bspline_curve {

/// A faired path as what a spline is held to. `chordLength`: L of (4). O(n).
[[nodiscard]] FairedShape fairedShapeOf(
    const PickPath& faired, const SolverOptions& options, double chordLength
);

}  // namespace bspline_curve
