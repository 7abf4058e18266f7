// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/simplify/shell_editor.h"

#include <memory>

namespace bspline_curve {

/// The shell that an editor has arrived at, for curves: pillars numbered in the order of the split,
/// prisms with their neighbours, faces numbered as in `extended`.
[[nodiscard]] Shell exportShell(
    const ShellEditor& editor, const std::shared_ptr<const ExtendedSurface>& extended
);

}  // namespace bspline_curve
