// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/shell_simplifier.h"
#include "surface/surface_band.h"

#include <memory>
#include <span>

namespace bspline_curve {

/// A shell around some faces of a surface. Face and vertex numbers in base and build are those of
/// the band.
struct BandShell {
    SurfaceBand band;
    std::shared_ptr<const ShellBase> base;  ///< in the frame of the whole surface's shell
    ShellBuild build;
};

/// Builds the shell of a band alone: the faces given, and those that make them a manifold
/// (cutBand). It is a valid shell of the band in every respect that checkShell(band.surface, …)
/// checks; ghosts continue it beyond its rim as beyond a boundary, and shadows there are on no
/// face. Lengths in the options are relative to the whole surface. Directions and edge lengths at
/// vertices all of whose faces are in the band are those of the whole surface; smoothed directions
/// as many rings from the rim as there are smoothing passes.
///
/// The rest of the surface is not looked at, and may reach into the shell, where pillars grow as
/// if it were not there. This does no harm to the projection: prisms know faces of the band only,
/// so each point of the shell has one shadow, and that is on the band. But heights then measure the
/// distance to the band, not to whatever part of the surface is nearest.
///
/// Throws InputError (EmptyMesh, IndexOutOfRange, BadOption), Cancelled. O(n log n) for n faces of
/// the band (60 us each for a simplified shell), and one pass over the vertices of the whole.
[[nodiscard]] BandShell buildBandShell(
    const Surface& whole,
    std::span<const int> faces,
    const ShellOptions& options,
    const Progress& progress = {}
);

}  // namespace bspline_curve
