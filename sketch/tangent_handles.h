// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/drawing_session.h"
#include "bspline_curve/sketch.h"

#include <optional>

// A pick with a direction has a handle on either side, which turns it when it is dragged.
namespace bspline_curve {

/// Where a handle is: `pixels` from its pick as the pointer's viewer sees them, were the tangent
/// seen from the side. `side`: 1 ahead, -1 behind. None where that side has no direction.
[[nodiscard]] std::optional<Vec3> tangentHandle(
    const SketchPick& pick, int side, const Pointer& pointer, double pixels
);

/// The side of the handle under the pointer, within `radius` pixels; 0: none. `depth`: of the
/// surface there; handles that are farther behind it than their pixels are hidden.
[[nodiscard]] int tangentHandleUnder(
    const Pointer& pointer, double depth, const SketchPick& pick, double pixels, double radius
);

/// From a pick towards the pointer in the plane with this normal, unit length. None where the
/// pointer looks along the plane, or at the pick.
[[nodiscard]] std::optional<Vec3> directionTowards(
    const Pointer& pointer, const SketchPick& pick, const Vec3& normal
);

}  // namespace bspline_curve
