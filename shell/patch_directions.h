// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/patch_levels.h"

#include <vector>

namespace bspline_curve {

/// The largest patches of a surface that are still many enough to smooth directions over: no wider
/// than 0.005 times the root of its area. Null where its faces are hardly smaller than that.
[[nodiscard]] const PatchLevels::Level* patchesToSmoothOver(const PatchLevels& patches);

/// Unit directions of the finest patches, as smooth as averages over patchesToSmoothOver(), which
/// must be there, and their neighbours' neighbours. `faceNormals`: unit. O(#F).
[[nodiscard]] std::vector<Vec3> smoothPatchDirections(
    const PatchLevels& patches, const std::vector<Vec3>& faceNormals
);

}  // namespace bspline_curve
