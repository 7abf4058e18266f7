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

/// Keeps nodes away from the boundary of a surface, as far as a clearance (>= 0) says; where faces
/// beside it are narrow, by a third of their height. All in the shell's frame, O(1) each.
class BoundaryGuard {
public:
    BoundaryGuard(const ExtendedSurface& extended, const FibreProjector& finder)
        : extended_(extended), finder_(finder) {}

    /// Whether a face has the boundary at a side.
    [[nodiscard]] bool isBeside(int face) const;

    /// How far it is to the boundary in the face of a node; infinite where that is not beside it.
    [[nodiscard]] double distanceOf(const SurfaceNode& node) const;

    /// Whether a node is no farther from the boundary than the clearance, in its face or in a
    /// corner of that. O(d) for d faces around a corner.
    [[nodiscard]] bool isNear(const SurfaceNode& node, double clearance) const;

    /// Where a node is no farther from the boundary than it has to be: a unit direction in its face
    /// from the boundary inwards. Zero elsewhere.
    [[nodiscard]] Vec3 inwardsAt(const SurfaceNode& node, double clearance) const;

    /// Puts a node that is beyond the boundary, or too near to it, where it is near enough.
    void putBack(SurfaceNode& node, double clearance) const;

private:
    struct Side {
        int corner = -1;      ///< opposite to it; -1: none
        double height = 0.0;  ///< of that corner over the side
        double share = 0.0;   ///< of the node, of that corner
    };

    [[nodiscard]] bool isBeyond(int face) const;
    [[nodiscard]] Side sideOf(const SurfaceNode& node) const;
    [[nodiscard]] bool isOnBoundary(int face, int corner) const;

    const ExtendedSurface& extended_;
    const FibreProjector& finder_;
};

}  // namespace bspline_curve
