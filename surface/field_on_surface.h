// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/field.h"
#include "surface/surface.h"

#include <memory>
#include <vector>

namespace bspline_curve {

/// The field of values at a surface's own vertices.
[[nodiscard]] ScalarField fieldOf(const Surface& surface, std::vector<double> values);

/// A field's values at a surface's own vertices: as they were made there, or carried over from the
/// surface's input. Null: there is no field. Throws InputError (BadField) where it has not one
/// value per vertex of the input. Costs nothing where nothing was mended.
[[nodiscard]] std::shared_ptr<const std::vector<double>> valuesOn(
    const Surface& surface, const ScalarField& field
);

}  // namespace bspline_curve
