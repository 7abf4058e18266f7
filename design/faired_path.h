// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/options.h"
#include "design/initial_path.h"
#include "design/near_picks.h"
#include "design/path_field.h"
#include "shell/extended_surface.h"
#include "surface/patch_levels.h"

#include <optional>
#include <span>

namespace bspline_curve {

/// A path through the same picks that bends least along the surface: a polyline of points evenly
/// spaced from pick to pick, at which
///   (1 - lambda) L integral kappa_g^2 ds + lambda (L / L_0)^2
/// has come to rest, with kappa_g the geodesic curvature, L the length and L_0 that of the polygon
/// of picks. It does not depend on a parameter or on the scale. Parameters are those by length.
///
/// By Gauss-Newton steps of one unknown per point, its move across the path, on ever more points.
/// The time hardly depends on how many faces lie between; about 1 microsecond per point and step.
/// It stays on the surface: points that come as near to its boundary as the clearance (in the
/// shell's frame, > 0) stay there until the energy draws them inwards. And it becomes no longer
/// than one and a half times the path before.
///
/// Nothing where it comes to rest in a cusp; from another path it may not. Nothing either where it
/// has no length. `options`: closed and tension (lambda). `patches`: see FibreProjector.
///
/// `leeways`: how near it keeps to each pick (empty: it passes all); the picks of the result are
/// the points of the path nearest to them, with ascending parameters, and may be the same. Bounds
/// hold but for roundings, or where the path did not come to rest: to be checked.
[[nodiscard]] std::optional<PickPath> fairedPath(
    const ExtendedSurface& extended,
    const PatchLevels* patches,
    const PickPath& path,
    const SolverOptions& options,
    double clearance,
    std::span<const PickLeeway> leeways = {},
    const PathField& field = {}
);

}  // namespace bspline_curve
