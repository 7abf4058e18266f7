// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/curve_options.h"
#include "bspline_curve/field.h"
#include "bspline_curve/progress.h"
#include "surface/surface.h"

#include <span>
#include <vector>

// What draws a curve besides its picks, made of a mesh's quality and selections.
namespace bspline_curve {

/// A field that is asked for. `layer`: what goes with the surface's input; its own mesh is not
/// looked at. Throws InputError: as makeField(), and where there is no quality that the field could
/// be; Cancelled.
[[nodiscard]] ScalarField fieldOf(
    const LayerInput& layer,
    const Surface& surface,
    const FieldRequest& request,
    const Progress& progress = {}
);

struct CurveGuides {
    ScalarField field;
    Region avoid;
};

/// The field that a curve is to follow, and the faces that it avoids. Throws likewise.
[[nodiscard]] CurveGuides curveGuides(
    const LayerInput& layer,
    const Surface& surface,
    const CurveOptions& options,
    const Progress& progress = {}
);

/// A per-vertex field along a polyline: one value per polyline vertex, interpolated linearly in its
/// face.
[[nodiscard]] std::vector<double> fieldAlong(
    const SurfacePolyline& polyline,
    const std::vector<Triangle>& faces,
    std::span<const double> field
);

}  // namespace bspline_curve
