// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace bspline_curve {

inline constexpr double kMaxShellThickness = 1000.0;

struct ShellOptions {
    /// Largest distance of top and bottom from the surface, in mean lengths of the edges at each
    /// vertex, in (0, kMaxShellThickness].
    double thickness = 0.75;
    /// Rounds of averaging of the pillar directions, >= 0.
    int smoothingPasses = 3;

    /// Throws InputError (BadOption).
    void validate() const;
};

}  // namespace bspline_curve
