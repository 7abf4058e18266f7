// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/progress.h"
#include "bspline_curve/shell.h"
#include "shell/extended_surface.h"
#include "shell/shell.h"

#include <utility>
#include <vector>

namespace bspline_curve {

/// What the builder did, for reports and tests.
struct ShellBuildReport {
    int orientationRounds = 0;
    int intersectionRounds = 0;
    /// Faces without a prism, ascending: curves cannot pass them.
    std::vector<int> blockedFaces;
    /// Pairs of faces of the surface that were found to intersect.
    std::vector<std::pair<int, int>> selfIntersections;
};

struct ShellBuild {
    Shell shell;
    ShellBuildReport report;
};

/// Builds the shell of full resolution: one prism per face, each pillar as long as asked or as the
/// invariants allow. Every tetrahedron of the split is positive (exact predicate); top, bottom and
/// the walls where the shell ends meet neither themselves nor each other (exact), and no component
/// lies inside of another. So no two prisms overlap. Pillars are shorter where else projections
/// would lose digits (kMostStretch). Faces where that is impossible (the surface
/// crosses itself, or turns back on itself in a vertex) get no prism and are reported; ghosts give
/// way to the surface.
/// Throws Cancelled where the callback asks for it. O(n log n); 86,000 faces take about 0.5 s.
[[nodiscard]] ShellBuild buildShell(
    const ExtendedSurface& extended, const ShellOptions& options, const Progress& progress = {}
);

}  // namespace bspline_curve
