// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/options.h"
#include "shell/extended_surface.h"
#include "surface/picks.h"

#include <span>
#include <vector>

namespace bspline_curve {

/// Of each point of a curve the unit direction in which it is to be passed, in its tangent plane;
/// zero: any. Empty where none is asked for. Of picks at one point the first with a direction
/// counts. `asked`: see CurveInputs. `corners`: points, ascending. Throws InputError (BadOption)
/// where there are not as many directions as picks, one is not finite, is normal to the surface or
/// belongs to a corner inside the curve, or the options cannot meet any.
[[nodiscard]] std::vector<Vec3> tangentsOf(
    const ExtendedSurface& extended,
    const LocatedPicks& located,
    std::span<const Vec3> asked,
    std::span<const int> corners,
    const SolverOptions& options
);

/// How well a curve meets them; picks are those as given.
[[nodiscard]] std::vector<MetTangent> metTangents(
    const ExtendedSurface& extended,
    const LocatedPicks& located,
    std::span<const Vec3> tangents,
    const Curve& curve
);

}  // namespace bspline_curve
