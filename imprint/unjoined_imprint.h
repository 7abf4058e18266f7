// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "imprint/imprint.h"

namespace bspline_curve {

/// An imprint with the seams of its input, which mending has joined: each face has the vertices of
/// its own side again. A vertex of a curve on a seam is doubled: the side whose edge has the lower
/// vertices keeps it, the copy comes behind all others, with its place in a face of its own side.
/// Faces, curves and crossings stay as they are; so where a curve passes to the other side of a
/// seam, its next edge starts at a copy of its vertex. `joined`: of this surface, from imprint().
/// O(n). Where no seams were joined the result is the same imprint.
[[nodiscard]] ImprintedMesh unjoined(const Surface& surface, const ImprintedMesh& joined);

}  // namespace bspline_curve
