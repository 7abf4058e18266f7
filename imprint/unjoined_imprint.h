// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "imprint/imprint.h"

namespace bspline_curve {

/// An imprint with the input's own vertices at the corners of its faces, see
/// Provenance::inputCorners(): where mending has joined seams, each face has the vertices of its
/// own side again. A vertex of a curve on a seam is doubled: the side whose edge has the lower
/// vertices keeps it, the copy comes behind all others, with its place in a face of its own side.
/// Faces stay in their order; curves and crossings name one vertex at each place, so that where a
/// curve passes to the other side of a seam, its next edge starts at a copy of its vertex. Vertices
/// that no face has any more are left out, those of the input excepted. `joined`: of this surface,
/// from imprint(). O(n). Where the surface has no such corners the result is the same imprint.
[[nodiscard]] ImprintedMesh unjoined(const Surface& surface, const ImprintedMesh& joined);

}  // namespace bspline_curve
