// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/curve_problem.h"

namespace bspline_curve {

/// How far top and bottom are from the surface at the picks, on average, relative to those of a
/// shell of full resolution with default options; at least 1. Relative heights times this are
/// comparable between shells: what was measured in thin shells (how high a first curve may be, how
/// stiff E_dist has to be) holds for thick ones as well. 1 in a shell of full resolution.
[[nodiscard]] double relativeReach(const CurveProblem& problem);

}  // namespace bspline_curve
