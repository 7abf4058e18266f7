// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/drawing_session.h"
#include "bspline_curve/sketch.h"
#include "surface/surface.h"

#include <memory>
#include <vector>

namespace bspline_curve {

/// The feature to which a point of a surface snaps: of those within `reach` (user's unit) along
/// connected faces the nearest pick of a curve that is shown and other than `own` (-1: any), else
/// the nearest point of a boundary or crease edge, else the vertex with the largest ridge or
/// valley, else the nearest vertex. Linear in the number of faces within reach.
[[nodiscard]] Snap snap(
    const Surface& surface,
    const Sketch& sketch,
    int own,
    const SurfacePoint& point,
    double reach,
    const SnapOptions& options = {}
);

}  // namespace bspline_curve
