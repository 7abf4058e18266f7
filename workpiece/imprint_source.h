// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/imprint.h"
#include "surface/surface.h"
#include "utility/go_on.h"

#include <memory>
#include <span>
#include <vector>

namespace bspline_curve {

/// What an imprint was made on.
struct Imprint::Source {
    /// The workpiece's surface, or one that was joined anew for curves that pass from sheet to
    /// sheet.
    std::shared_ptr<const Surface> surface;
    /// Of strokes: their lines, with the surface's own faces.
    std::vector<SurfacePolyline> spines{};
    double halfWidth = 0.0;
};

/// Lines of the input of a surface as edges; parts are not found yet.
[[nodiscard]] Imprint imprintOf(
    Imprint::Source source,
    std::span<const SurfacePolyline> lines,
    const ImprintOptions& options,
    const GoOn& goOn
);

}  // namespace bspline_curve
