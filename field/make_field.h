// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/field.h"
#include "surface/surface.h"

namespace bspline_curve {

/// makeField() of a surface that is there already. Quality and region are those of its input, as is
/// the field, which keeps its values on the surface itself.
[[nodiscard]] ScalarField makeField(
    const Surface& surface,
    const FieldOptions& options,
    const FieldInputs& inputs = {},
    const Progress& progress = {}
);

}  // namespace bspline_curve
