// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/shell.h"
#include "shell/extended_surface.h"
#include "shell/shell.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace bspline_curve {

struct ShellCheckOptions {
    int maxReportedIds = 8;  ///< per invariant, >= 0
    /// Fibres of each prism of a simplified shell that are followed through the surface, >= 0.
    int fibresPerPrism = 20;
    std::uint64_t seed = 1;  ///< of the choice of the fibres
};

/// What was found about each invariant. In a simplified shell "the surface" are the faces of the
/// extended surface that are not blocked, and the ghosts that some prism lists. A face "meets" a
/// tetrahedron where it passes through its inside, or has an area in common with one of its sides;
/// touching in a point or a line does not count.
struct ShellCheck {
    /// Every tetrahedron of the split has positive volume. Ids: tetrahedra.
    ShellInvariant positiveTetrahedra{.name = "positive tetrahedra", .firstIds = {}};
    /// The boundary of the shell (top, bottom, and the walls where it ends) meets itself nowhere
    /// but in shared corners and edges, and just one closed part of it looks outwards in each
    /// component: no bottom has turned inside out. With positive tetrahedra each component of the
    /// shell is then embedded: a point has one prism at most. Ids: the prisms of each pair, in
    /// turn.
    ShellInvariant separateLayers{.name = "separate layers", .firstIds = {}};
    /// No component of the shell lies inside of another one. Ids: a pillar of the inner component
    /// and the prism that holds it, in turn.
    ShellInvariant separateComponents{.name = "separate components", .firstIds = {}};
    /// The extended surface is the surface, up to the vertices that it says it moved, and every
    /// face is transversal: its normal has a positive dot product with the fibre direction (the
    /// half pillar that it holds) of each tetrahedron that the face meets. Full resolution: the
    /// surface is the middle of the shell. Ids: faces of the extended surface.
    ShellInvariant transversalSurface{.name = "transversal surface", .firstIds = {}};
    /// Every face of the surface lies inside of the shell and touches neither top nor bottom; with
    /// the walls where the shell ends it has at most such vertices in common as are middles of
    /// pillars there, and the edges between these. Ghosts may leave through these walls. Full
    /// resolution: follows from the middle. Ids: faces of the extended surface.
    ShellInvariant containedSurface{.name = "contained surface", .firstIds = {}};
    /// Of each prism some fibres, chosen at random, meet the surface exactly once; at most once
    /// where the surface ends in the prism. With the invariants above one fibre of a prism stands
    /// for all where the surface does not end. Full resolution: follows from the middle. Ids:
    /// prisms.
    ShellInvariant singleCrossings{.name = "single crossings", .firstIds = {}};
    /// Full resolution: every face of the surface has exactly one prism or is listed as blocked,
    /// and no prism leads to a blocked one. Simplified: every prism lists every face that meets it,
    /// ascending, every face is listed somewhere, and no blocked one is. Ids: faces of the extended
    /// surface.
    ShellInvariant completeTracking{.name = "complete tracking", .firstIds = {}};
    /// Neighbours agree about walls, pillars, diagonals and orientation; prisms with a common wall
    /// are neighbours. Ids: prisms.
    ShellInvariant consistentNeighbours{.name = "consistent neighbours", .firstIds = {}};

    [[nodiscard]] std::array<const ShellInvariant*, 8> invariants() const {
        return {
            &positiveTetrahedra,
            &separateLayers,
            &separateComponents,
            &transversalSurface,
            &containedSurface,
            &singleCrossings,
            &completeTracking,
            &consistentNeighbours
        };
    }

    [[nodiscard]] bool passed() const;
};

/// Checks the invariants of a shell of either form with exact predicates, from its plain data
/// (pillars, prisms, tracks, kSlabSplit) and the extended surface alone. Shares no test with those
/// who build, simplify or query shells: only predicates and the numbers of points. `blockedFaces`
/// lists the faces of the surface that are said to have no prism, ascending (ShellBuildReport).
/// Indices must be valid. O(n log n) for full resolution; simplified shells in addition O(pairs of
/// faces and prisms whose boxes overlap).
[[nodiscard]] ShellCheck checkShell(
    const Surface& surface,
    const ExtendedSurface& extended,
    const Shell& shell,
    std::span<const int> blockedFaces,
    const ShellCheckOptions& options = {}
);

}  // namespace bspline_curve
