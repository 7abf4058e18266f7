// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fill/patch_refinement.h"

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace bspline_curve {

/// The faces beside a rim as a patch: those that pass the rim in its order, or in the other one
/// where `isBehind`; then they are turned over, so that they pass the rim in its order, and inner
/// edges between two points of the rim are halved, so that there is no edge that the mesh has. None
/// where the faces beside the rim are no disc with this boundary alone, or more than `most`. Points
/// have no sizes. O(n) for n faces of the mesh, and O(m log m) for m of the patch.
[[nodiscard]] std::optional<Patch> sheetBeside(
    const TriangleMesh& mesh,
    const std::vector<int>& rim,
    bool isBehind,
    std::size_t most = std::numeric_limits<std::size_t>::max()
);

/// For each inner point of a patch a direction off it, on whose other side all faces around the
/// point are, if there is one; as long as the edges around are in the mean. Zero on the rim. O(n).
[[nodiscard]] std::vector<Vec3> waysOff(const Patch& patch);

}  // namespace bspline_curve
