// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/passages.h"
#include "surface/repair.h"

#include <vector>

namespace bspline_curve {

/// A mended mesh joined anew, so that faces can go on into each other at the passages as well: each
/// edge of more than two faces is divided, and each passage has a part of it. No face is cut out of
/// its neighbours. The origins of faces are those of the mended mesh; vertices have none. Takes as
/// long as repairMesh().
[[nodiscard]] MeshRepair rejoined(
    const TriangleMesh& mended,
    const std::vector<int>& vertexOrigins,
    const std::vector<Passage>& passages
);

}  // namespace bspline_curve
