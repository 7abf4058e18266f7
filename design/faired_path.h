// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/options.h"
#include "design/initial_path.h"
#include "shell/extended_surface.h"
#include "surface/patch_levels.h"

#include <optional>

namespace bspline_curve {

/// A path through the same picks that bends least along the surface: a polyline of points evenly
/// spaced from pick to pick, at which
///   (1 - lambda) L integral kappa_g^2 ds + lambda (L / L_0)^2
/// has come to rest, with kappa_g the geodesic curvature, L the length and L_0 that of the polygon
/// of picks. It does not depend on a parameter or on the scale. Parameters are those by length.
///
/// By Gauss-Newton steps of one unknown per point, its move across the path, on ever more points.
/// The time hardly depends on how many faces lie between; about 1 microsecond per point and step.
///
/// Nothing either where it comes to rest in a cusp or half again as long; from another path it may
/// not. `options`: closed and tension (lambda). `patches`: see FibreProjector. Nothing where the
/// path leaves the surface over its boundary, or has no length.
[[nodiscard]] std::optional<PickPath> fairedPath(
    const ExtendedSurface& extended,
    const PatchLevels* patches,
    const PickPath& path,
    const SolverOptions& options
);

/// A faired path as what a spline is held to. `chordLength`: L of (4). O(n).
[[nodiscard]] FairedShape fairedShapeOf(
    const PickPath& faired, const SolverOptions& options, double chordLength
);

}  // namespace bspline_curve
