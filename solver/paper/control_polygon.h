// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/initial_curve.h"

namespace bspline_curve {

/// First spline by Alg. 2 of the paper: its control polygon runs in turn to the top and to the
/// bottom of the shell over the picks, with midpoints of the initial path path where a segment
/// would leave the shell. It may leave the shell all the same (the paper's eta, see
/// integrateSamples).
[[nodiscard]] SplineCurve makeControlPolygon(
    const CurveProblem& problem, const InitialPath& initialPath
);

}  // namespace bspline_curve
