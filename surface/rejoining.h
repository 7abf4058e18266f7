// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/passages.h"
#include "surface/repair.h"

#include <vector>

namespace bspline_curve {

/// A mended mesh joined anew, so that faces can go on into each other at the passages as well.
/// Edges are divided where pairs of faces that share one pass, unless they are too short. The
/// origins of faces are those of the mended mesh; vertices have none. Takes as long as
/// repairMesh(). `roots`: see PartedEdges.
[[nodiscard]] MeshRepair rejoined(
    const TriangleMesh& mended,
    const std::vector<int>& roots,
    const PartedEdges& parted,
    const Passages& passages
);

}  // namespace bspline_curve
