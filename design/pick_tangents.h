// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/options.h"
#include "bspline_curve/tangent.h"
#include "shell/extended_surface.h"
#include "surface/picks.h"

#include <span>
#include <vector>

namespace bspline_curve {

/// Of each point of a curve the unit directions in which it is to be passed, in its tangent plane;
/// zero: any. Empty where none is asked for. Of picks at one point the first with a direction
/// counts. `asked`: see CurveInputs. `corners`: points, ascending. Throws InputError (BadOption)
/// where there are not as many directions as picks, one is not finite or is normal to the surface,
/// a point that is no corner has two, or the options cannot meet any.
[[nodiscard]] std::vector<PickTangent> tangentsOf(
    const ExtendedSurface& extended,
    const LocatedPicks& located,
    std::span<const PickTangent> asked,
    std::span<const int> corners,
    const SolverOptions& options
);

/// Those of a smooth piece through some of the points: where it begins the one after the point,
/// where it ends the one before it. Empty where it has none.
[[nodiscard]] std::vector<Vec3> tangentsOfPiece(
    std::span<const PickTangent> tangents, std::span<const int> points, bool closed
);

/// How well a curve meets them; picks are those as given.
[[nodiscard]] std::vector<MetTangent> metTangents(
    const ExtendedSurface& extended,
    const LocatedPicks& located,
    std::span<const PickTangent> tangents,
    const Curve& curve
);

}  // namespace bspline_curve
