// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/field.h"
#include "surface/surface.h"

#include <vector>

namespace bspline_curve {

/// makeField() of a surface that is validated already.
[[nodiscard]] std::vector<double> makeField(
    const Surface& surface,
    const FieldOptions& options,
    const FieldInputs& inputs = {},
    const Progress& progress = {}
);

}  // namespace bspline_curve
