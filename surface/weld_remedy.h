// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/error.h"
#include "bspline_curve/progress.h"
#include "surface/surface.h"
#include "surface/triangle_tree.h"

#include <vector>

namespace bspline_curve {

/// For picks on different components: the least of the distances 1, 2, 5, 10, … times 1e-6
/// diagonals, up to 0.01, within which vertices must be joined for picks on one component, see
/// repairMesh(); each that boundaries promise is tried on the whole mesh. None where none helps.
/// Throws Cancelled.
[[nodiscard]] Remedy weldFor(
    const Surface& surface,
    const TriangleTree& tree,
    const std::vector<Vec3>& picks,
    bool closed,
    const Progress& progress
);

}  // namespace bspline_curve
