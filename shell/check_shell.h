// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/shell.h"
#include "shell/shell_base.h"

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace bspline_curve {

/// How an invariant of the shell fared.
struct InvariantCheck {
    std::string_view name;
    bool holds = true;
    std::int64_t violations = 0;
    /// What the ids of the first offenders number is said at each invariant.
    std::vector<int> firstIds;
};

struct ShellCheckOptions {
    int maxReportedIds = 8;  ///< per invariant, >= 0
};

struct ShellCheck {
    /// Every tetrahedron of the split has positive volume. Ids: tetrahedra.
    InvariantCheck positiveTetrahedra{.name = "positive tetrahedra", .firstIds = {}};
    /// The boundary of the shell (top, bottom, and the walls where it ends) meets itself nowhere
    /// but in shared corners and edges. With positive tetrahedra each component of the shell is
    /// then embedded: a point has one prism at most. Ids: the prisms of each pair, in turn.
    InvariantCheck separateLayers{.name = "separate layers", .firstIds = {}};
    /// No component of the shell lies inside of another one. Ids: a pillar of the inner component
    /// and the prism that holds it, in turn.
    InvariantCheck separateComponents{.name = "separate components", .firstIds = {}};
    /// The surface is the middle of the shell, up to the vertices that the base says it moved, and
    /// every face is transversal: its normal has a positive dot product with the fibre direction in
    /// each tetrahedron that it bounds and along each half pillar at its vertices. Ids: faces of
    /// the base.
    InvariantCheck transversalSurface{.name = "transversal surface", .firstIds = {}};
    /// Every face of the surface has exactly one prism or is listed as blocked, and no prism leads
    /// to a blocked one. Ids: faces.
    InvariantCheck completeTracking{.name = "complete tracking", .firstIds = {}};
    /// Neighbours agree about walls, pillars, diagonals and orientation; prisms with a common wall
    /// are neighbours. Ids: prisms.
    InvariantCheck consistentNeighbours{.name = "consistent neighbours", .firstIds = {}};

    [[nodiscard]] std::array<const InvariantCheck*, 6> invariants() const {
        return {
            &positiveTetrahedra,
            &separateLayers,
            &separateComponents,
            &transversalSurface,
            &completeTracking,
            &consistentNeighbours
        };
    }

    [[nodiscard]] bool passed() const;
};

/// Checks the invariants of a shell with exact predicates, from its plain data (pillars, prisms,
/// kSlabSplit) alone; shares no code with the builder. `blockedFaces` lists the faces of the
/// surface that are said to have no prism, ascending (ShellBuildReport). Indices must be valid.
/// O(n log n).
[[nodiscard]] ShellCheck checkShell(
    const Surface& surface,
    const ShellBase& base,
    const Shell& shell,
    std::span<const int> blockedFaces,
    const ShellCheckOptions& options = {}
);

}  // namespace bspline_curve
