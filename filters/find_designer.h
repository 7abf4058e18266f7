// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/progress.h"
#include "bspline_curve/shell.h"
#include "filters/designer_cache.h"
#include "filters/layer_input.h"
#include "surface/mending.h"

namespace bspline_curve {

/// The designer for a layer: a kept one, else one whose shell comes from the cache on disk or is
/// built. Throws InputError (what the mesh was refused for, where `mending` is strict; ids are the
/// layer's, see madeFrom()), Cancelled.
[[nodiscard]] DesignerCache::Found designerFor(
    const LayerInput& layer,
    const ShellOptions& shell,
    const MendingOptions& mending,
    DesignerCache& designers,
    const Progress& progress
);

}  // namespace bspline_curve
