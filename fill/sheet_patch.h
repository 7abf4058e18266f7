// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fill/patch_refinement.h"

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace bspline_curve {

/// Faces of a mesh that a rim bounds and nothing else, as a patch that has the rim's points first.
/// Its sizes are mean lengths of edges. `normals`: unit, for each point a direction on whose side
/// all faces around it are, if there is one; zero on the rim.
struct Sheet {
    Patch patch;
    std::vector<Vec3> normals;
};

/// The sheet beside a rim, which its faces pass in the rim's order, or in the other one where
/// `isBehind`; then the sheet is turned over, so that it passes the rim in its order, and inner
/// edges between two points of the rim are halved, so that it has no edge that the mesh has. None
/// where the faces beside the rim are no disc with this boundary alone, or more than `most`. O(n)
/// for n faces of the mesh, and O(m log m) for m of the sheet.
[[nodiscard]] std::optional<Sheet> sheetBeside(
    const TriangleMesh& mesh,
    const std::vector<int>& rim,
    bool isBehind,
    std::size_t most = std::numeric_limits<std::size_t>::max()
);

}  // namespace bspline_curve
