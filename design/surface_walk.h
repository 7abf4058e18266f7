// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "projection/fibre_projector.h"
#include "shell/extended_surface.h"

namespace bspline_curve {

/// A point on the surface, by its foot.
struct SurfaceNode {
    FootPoint foot;
    FootFrame frame;
    Vec3 position = Vec3::Zero();
};

/// Whether a walk over the surface leads from one node to the next, over sharp edges by short
/// steps. None leads over a right angle where fibres turn in less than a step; and the straight way
/// between two nodes may pass through the rim of a thin plate. About a microsecond.
[[nodiscard]] bool areJoined(
    const ExtendedSurface& extended,
    const FibreProjector& finder,
    const SurfaceNode& from,
    const SurfaceNode& to
);

/// Whether a node has left the surface over its boundary.
[[nodiscard]] bool isBeyondBoundary(const ExtendedSurface& extended, const SurfaceNode& node);

/// Puts a node from beyond the boundary onto the surface beside it, a little inside.
void putBack(const ExtendedSurface& extended, const FibreProjector& finder, SurfaceNode& node);

/// Where a node lies at the boundary, as putBack() leaves it: a direction in its face from the
/// boundary inwards. Zero elsewhere.
[[nodiscard]] Vec3 inwardsAtBoundary(const ExtendedSurface& extended, const SurfaceNode& node);

}  // namespace bspline_curve
