// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/progress.h"
#include "filters/layer_input.h"
#include "filters/requests.h"
#include "surface/region.h"

#include <vector>

// What draws a curve besides its picks, made of a layer's quality and selections.
namespace bspline_curve {

/// One value per vertex of the surface. Throws InputError: as makeField(), and where the layer has
/// no quality that the field could be.
[[nodiscard]] std::vector<double> fieldOf(
    const LayerInput& layer,
    const Surface& surface,
    const FieldRequest& request,
    const Progress& progress = {}
);

struct CurveGuides {
    bool hasField = false;
    std::vector<double> field;  ///< one value per vertex, or none
    Region avoid;
};

/// The field that a request asks for, and the faces that it avoids.
/// `layer`: what goes with the surface's mesh; its own mesh is not looked at. Throws InputError,
/// Cancelled.
[[nodiscard]] CurveGuides curveGuides(
    const LayerInput& layer,
    const Surface& surface,
    const CurveRequest& request,
    const Progress& progress = {}
);

}  // namespace bspline_curve
