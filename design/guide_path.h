// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/shell_base.h"
#include "solver/initial_curve.h"
#include "solver/obstacles.h"
#include "surface/surface.h"

#include <span>
#include <vector>

namespace bspline_curve {

struct PickPath {
    GuidePath guide;
    std::vector<PickConstraint> picks;  ///< with parameters by length along the guide
};

/// What paths meet on the surface.
struct Terrain {
    std::vector<int> blockedFaces;  ///< where no shell is: no path enters them; ascending
    /// What a unit of length costs in each face, finite and positive; empty: 1 everywhere.
    std::vector<double> faceCosts{};
    const Obstacles* obstacles = nullptr;  ///< what paths keep clear of; null: nothing
};

/// Paths from pick to pick, parametrised by length: geodesics where all faces cost the same.
/// Where there are obstacles they go round them, farther away where there is room.
/// Throws InputError (NoPath, SelfIntersection) naming the two picks.
[[nodiscard]] PickPath makePickPath(
    const Surface& surface,
    const ShellBase& base,
    const std::vector<SurfacePoint>& picks,
    bool closed,
    const Terrain& terrain
);

/// The cost of faces by which paths follow a field: 1 in the cheapest face, and more with mu and
/// `share` of the cost c of the field. Empty where the field has no say.
/// `vertexCosts`: c at each vertex, or empty.
[[nodiscard]] std::vector<double> faceCostsOf(
    const Surface& surface,
    std::span<const double> vertexCosts,
    const SolverOptions& options,
    double share = 1.0
);

}  // namespace bspline_curve
