// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/initial_curve.h"

namespace bspline_curve {

/// First spline by Alg. 2 of the paper: its control polygon runs in turn to the top and to the
/// bottom of the shell over the picks, with middles of Dijkstra's path where a segment would leave
/// the shell. It may leave the shell all the same (the paper's eta, see integrateSamples), but
/// where the energy is taken cell by cell: then the polygon gets more points. Nothing where faces
/// without a prism part the picks.
[[nodiscard]] std::optional<SplineCurve> makeControlPolygon(const CurveProblem& problem);

}  // namespace bspline_curve
