// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/whole_shell.h"
#include "shell/extended_surface.h"
#include "shell/shell.h"
#include "surface/surface.h"

namespace bspline_curve {

struct PrismCounts {
    int all = 0, ghosts = 0, pillars = 0;
};

/// Of the prisms that are not blocked.
[[nodiscard]] PrismCounts countPrisms(const Shell& shell);

[[nodiscard]] ShellThickness measureThickness(
    const Surface& surface, const ShellFrame& frame, const Shell& shell
);

}  // namespace bspline_curve
