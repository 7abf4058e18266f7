// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/solve_variant.h"

namespace bspline_curve {

/// The paper's way of each step for which the options ask for it; else the solver's own.
[[nodiscard]] const SolveVariant& paperVariant();

}  // namespace bspline_curve
