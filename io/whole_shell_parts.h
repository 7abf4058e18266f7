// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/whole_shell.h"
#include "shell/extended_surface.h"
#include "shell/shell_store.h"
#include "surface/surface.h"

#include <memory>
#include <span>

namespace bspline_curve {

/// What the shell of a workpiece is made of.
struct WholeShell::Parts {
    const Surface& surface;
    ShellOptions options;
    std::shared_ptr<const ExtendedSurface> extended;
    ObtainedShell obtained;
    ShellFigures figures;

    [[nodiscard]] const Shell& shell() const { return obtained.build.shell; }

    [[nodiscard]] std::span<const int> blockedFaces() const {
        return obtained.build.report.blockedFaces;
    }
};

}  // namespace bspline_curve
