// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/shell.h"
#include "shell/shell.h"

namespace bspline_curve {

/// O(n).
[[nodiscard]] ShellLayers makeShellLayers(const Shell& shell, const ShellFrame& frame);

}  // namespace bspline_curve
