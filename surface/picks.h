// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/surface.h"
#include "surface/triangle_tree.h"

#include <vector>

namespace bspline_curve {

/// Picks farther than this from the surface are refused (relative to the diagonal).
inline constexpr double kPickReachRelative = 0.01;
/// Consecutive picks nearer than this coincide (relative to the diagonal).
inline constexpr double kPickSeparationRelative = 1e-9;

/// Projects picked points to the surface (closest point), in order.
/// Throws InputError: TooFewPicks (fewer than 2, or 3 when closed), NonFiniteCoordinate,
/// PickTooFar, CoincidentPicks (consecutive ones; for a closed curve the last and the first too),
/// PicksOnDifferentComponents; each names the picks by their index from 0.
[[nodiscard]] std::vector<SurfacePoint> locatePicks(
    const Surface& surface, const TriangleTree& tree, const std::vector<Vec3>& picks, bool closed
);

}  // namespace bspline_curve
