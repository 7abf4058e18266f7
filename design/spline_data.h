// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "shell/extended_surface.h"
#include "solver/initial_curve.h"

#include <vector>

namespace bspline_curve {

/// A spline of the shell's frame as people keep it, with the parameters of its picks.
[[nodiscard]] SplineData splineDataOf(
    const SplineCurve& curve, const ShellFrame& frame, std::vector<double> pickParameters
);

}  // namespace bspline_curve
