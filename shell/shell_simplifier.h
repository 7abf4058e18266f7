// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/shell_builder.h"

#include <memory>

namespace bspline_curve {

/// What a simplified shell is wanted to look like. Lengths are relative to the longest side of the
/// surface's box.
struct SimplifyOptions {
    /// Largest distance between top and bottom along a pillar, in (0, 1].
    double thickness = 0.135;
    /// Middle edges shorter than this are collapsed where the invariants allow it, in (0, 1].
    double edgeLength = 1.0;

    /// Throws InputError (BadOption).
    void validate() const;
};

/// Builds a simplified shell: starts from the shell of full resolution around the base, then
/// collapses and flips edges, turns and lengthens pillars, each only where the invariants still
/// hold afterwards. Throws Cancelled where the callback asks for it.
[[nodiscard]] ShellBuild buildSimplifiedShell(
    const std::shared_ptr<const ShellBase>& base,
    const ShellOptions& start,
    const SimplifyOptions& options,
    const Progress& progress = {}
);

}  // namespace bspline_curve
