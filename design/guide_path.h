// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/shell_base.h"
#include "solver/initial_curve.h"
#include "surface/surface.h"

#include <vector>

namespace bspline_curve {

struct PickPath {
    GuidePath guide;
    std::vector<PickConstraint> picks;  ///< with parameters by length along the guide
};

/// Geodesics from pick to pick, parametrised by length. `blocked` faces are avoided.
/// Throws InputError (NoPath) naming the two picks.
[[nodiscard]] PickPath makePickPath(
    const Surface& surface,
    const ShellBase& base,
    const std::vector<SurfacePoint>& picks,
    bool closed,
    const std::vector<int>& blockedFaces
);

}  // namespace bspline_curve
