// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/shell.h"
#include "surface/types.h"

namespace bspline_curve {

/// Top and bottom of a shell as meshes, both oriented as the surface is; in the user's unit. Where
/// prisms are blocked they have holes, and beyond a boundary they go on as far as the shell does.
struct ShellLayers {
    TriangleMesh top, bottom;
};

/// O(n).
[[nodiscard]] ShellLayers makeShellLayers(const Shell& shell, const ShellFrame& frame);

}  // namespace bspline_curve
