// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/progress.h"
#include "bspline_curve/shell.h"
#include "shell/extended_surface.h"
#include "shell/shell_store.h"
#include "surface/patch_levels.h"
#include "surface/surface.h"
#include "surface/triangle_tree.h"
#include "utility/stopwatch.h"
#include "utility/threads.h"

#include <atomic>
#include <memory>

namespace bspline_curve {

/// A surface and what curves on it need of it, made once; the shell of the whole surface when it is
/// first asked for. Several threads may use it at once.
class PreparedSurface {
public:
    /// Two threads. `seconds`: what the surface took. Throws InputError (BadOption), Cancelled.
    PreparedSurface(
        std::shared_ptr<const Surface> surface,
        const ShellOptions& options,
        const Progress& progress = {},
        double seconds = 0.0
    );

    PreparedSurface(const PreparedSurface&) = delete;
    PreparedSurface& operator=(const PreparedSurface&) = delete;

    [[nodiscard]] const Surface& surface() const { return *surface_; }

    [[nodiscard]] const TriangleTree& tree() const { return tree_; }

    [[nodiscard]] const PatchLevels& patches() const { return patches_; }

    [[nodiscard]] const std::shared_ptr<const ExtendedSurface>& extended() const {
        return extended_;
    }

    [[nodiscard]] const ShellOptions& options() const { return options_; }

    /// Shorter edges count as that long where tolerances are relative to them.
    [[nodiscard]] double finestEdge() const { return finestEdge_; }

    /// The shell of the whole surface, of full resolution where the options say local. Where it is
    /// not there yet it is taken from the store (null: none) or built. Throws Cancelled.
    [[nodiscard]] const ObtainedShell& wholeShell(
        const Progress& progress = {}, const ShellStore* store = nullptr
    ) const;

    /// The same if it is there; else null.
    [[nodiscard]] const ObtainedShell* wholeShellIfBuilt() const;

    /// `extended`: what the others did not hide of it.
    struct Seconds {
        double validate = 0.0, tree = 0.0, extended = 0.0, wholeShell = 0.0;
    };

    [[nodiscard]] Seconds seconds() const;

private:
    template <class Make>
    auto orEndTasks(const Make& make);

    ShellOptions options_;
    Stopwatch watch_;
    std::shared_ptr<const Surface> surface_;
    double finestEdge_;
    double validateSeconds_;
    std::atomic<bool> isEnding_ = false;
    Progress untilEnd_ = [this](double, const char*) { return !isEnding_; };  // of other threads
    TaskResult<RoughBase> roughBase_;  // made by another thread meanwhile
    PatchLevels patches_;
    TaskResult<ExtendedSurface> futureBase_;  // likewise
    TriangleTree tree_;
    double treeSeconds_;
    std::shared_ptr<const ExtendedSurface> extended_;
    double baseSeconds_;
    mutable Mutex wholeMutex_;
    mutable std::unique_ptr<const ObtainedShell> whole_;
    mutable double wholeSeconds_ = 0.0;
};

}  // namespace bspline_curve
