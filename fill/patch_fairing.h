// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fill/patch_refinement.h"

namespace bspline_curve {

/// What the mesh around a patch adds at each point of its rim.
struct RimSurroundings {
    std::vector<Vec3> laplacians;  ///< sum of cotangent weights times differences, over its faces
    std::vector<Vec3> normals;     ///< sum of its faces' normals, of twice their area
    std::vector<char> isKnown;     ///< whether that is all there is; else it is not looked at
};

/// Moves the inner points so that the mean curvature varies least, in the mean square, with the
/// tangent planes of the surroundings at the rim. The Laplacian of the position is compared with
/// one mean curvature along the normals, which is found in turn; that of a sphere has no variance,
/// so that a piece cut from a sphere comes back. Finite elements with cotangent weights
/// (M. Botsch and L. Kobbelt, An intuitive framework for real-time freeform modeling, 2004, solve
/// for none in its place). O(n^1.5) a step, of which there are at most `steps`.
/// Throws Cancelled.
void fairPatch(
    Patch& patch, const RimSurroundings& around, int steps, const Progress& progress = {}
);

/// Likewise for a patch that was fair before its faces were divided: takes out the short waves that
/// this left, by a few steps of conjugate gradients. O(n). Throws Cancelled.
void fairDivided(Patch& patch, const RimSurroundings& around, const Progress& progress = {});

}  // namespace bspline_curve
