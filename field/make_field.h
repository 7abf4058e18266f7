// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "field/field_options.h"
#include "surface/progress.h"
#include "surface/surface.h"

#include <span>
#include <vector>

namespace bspline_curve {

/// What some kinds are made from.
struct FieldInputs {
    std::span<const double> quality{};  ///< Quality: one value per vertex
    std::span<const int> region{};      ///< Obstacle: faces, see Region
};

/// One value per vertex, as FieldKind says, then smoothed, normalised and inverted as the options
/// ask. Every kind is the same in every unit and position of the surface (quality: as given), and
/// does not depend on the number of threads.
/// Throws InputError: BadOption; BadField (no crease or no boundary to measure from; a quality of
/// another size, or that is not finite, naming the vertices; a region that obstacleField refuses).
/// Throws Cancelled.
[[nodiscard]] std::vector<double> makeField(
    const Surface& surface,
    const FieldOptions& options,
    const FieldInputs& inputs = {},
    const Progress& progress = {}
);

}  // namespace bspline_curve
