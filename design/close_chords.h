// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/extended_surface.h"
#include "surface/patch_levels.h"
#include "surface/surface_point.h"

#include <optional>
#include <span>
#include <vector>

namespace bspline_curve {

/// Brings the chords between the points of a path near to the surface: halves each at the foot of
/// its midpoint until that lies within a distance of the surface, or has been halved eight times.
/// The time depends on how much the surface bends along the path, not on how many faces it has.
///
/// `patches`: see FibreProjector. `path`: its points stay. `distance`: in the shell's frame.
/// Nothing where a foot lies beyond the surface's boundary.
[[nodiscard]] std::optional<std::vector<SurfacePoint>> withCloseChords(
    const ExtendedSurface& extended,
    const PatchLevels* patches,
    std::span<const SurfacePoint> path,
    double distance
);

}  // namespace bspline_curve
