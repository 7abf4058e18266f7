// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "field/field_options.h"
#include "surface/progress.h"
#include "surface/surface.h"

#include <vector>

namespace bspline_curve {

/// One value per vertex, as FieldKind says, then smoothed as the options ask. Every kind is the
/// same in every unit and position of the surface, and does not depend on the number of threads.
/// Throws InputError: BadOption; BadField (no crease, no boundary to measure from). Throws
/// Cancelled.
[[nodiscard]] std::vector<double> makeField(
    const Surface& surface, const FieldOptions& options, const Progress& progress = {}
);

}  // namespace bspline_curve
