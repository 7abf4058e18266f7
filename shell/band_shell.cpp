// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/band_shell.h"

#include <algorithm>
#include <utility>

namespace bspline_curve {

BandShell buildBandShell(
    const Surface& whole,
    std::span<const int> faces,
    const ShellOptions& options,
    const Progress& progress
) {
    options.validate();
    SurfaceBand band = cutBand(whole, faces);
    auto base = std::make_shared<const ShellBase>(
        makeShellBase(band.surface, options.smoothingPasses, frameOf(whole))
    );
    // The builder takes lengths relative to the box of what it gets.
    const double share = longestSideOf(whole) / longestSideOf(band.surface);
    ShellOptions local = options;
    local.targetThickness = std::min(1.0, share * options.targetThickness);
    local.targetEdgeLength = std::min(1.0, share * options.targetEdgeLength);
    ShellBuild build = makeShell(base, local, progress);
    return {.band = std::move(band), .base = std::move(base), .build = std::move(build)};
}

}  // namespace bspline_curve
