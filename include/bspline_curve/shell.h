// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace bspline_curve {

inline constexpr double kMaxShellThickness = 1000.0;

enum class ShellKind {
    Simplified,      ///< few thick prisms; takes seconds on large meshes, once
    FullResolution,  ///< one thin prism per face
    Local            ///< the fibres of those, near each curve only, while that is enough for it
};

/// As users write it.
[[nodiscard]] const char* name(ShellKind kind);

struct ShellOptions {
    ShellKind kind = ShellKind::Local;
    /// Full resolution: largest distance of top and bottom from the surface, in mean lengths of the
    /// edges at each vertex, in (0, kMaxShellThickness].
    double thickness = 0.75;
    /// Rounds of averaging of the pillar directions, >= 0.
    int smoothingPasses = 3;
    /// Simplified: largest length of a pillar, bottom to top, relative to the longest side of the
    /// surface's box, in (0, 1]. Pillars are shorter where something is in their way.
    double targetThickness = 0.135;
    /// Simplified: middle edges shorter than this are collapsed where the invariants allow it,
    /// relative to the longest side of the surface's box, in (0, 1].
    double targetEdgeLength = 1.0;

    /// Throws InputError (BadOption).
    void validate() const;

    friend bool operator==(const ShellOptions&, const ShellOptions&) = default;
};

/// The shell that curves are sought in.
struct ShellSummary {
    ShellKind kind = ShellKind::Local;
    bool isFromStore = false;
    std::vector<std::string> notes;  ///< about the store; empty where all is well
};

/// An invariant of a shell, and how it fared.
struct ShellInvariant {
    std::string_view name;
    bool holds = true;
    std::int64_t violations = 0;
    std::vector<int> firstIds;  ///< of what violates it; docs/SHELLS.md tells what they number
};

/// Top and bottom of a shell as meshes, both oriented as the surface is; in the user's unit. Where
/// prisms are blocked they have holes, and beyond a boundary they go on as far as the shell does.
struct ShellLayers {
    TriangleMesh top, bottom;
};

}  // namespace bspline_curve
