// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filter_bspline_curve/common/layer_arrays.h"
#include "filter_bspline_curve/common/polyline_layer.h"
#include "filters/run_curve_uses.h"
#include "host_document.h"

#include <string>
#include <vector>

namespace bspline_curve {

/// Adds a layer for each mesh, named after the surface's layer and under its matrix; the first
/// becomes the current one. What the surface has per vertex, face and wedge comes along: colours,
/// qualities, texture coordinates, selections, custom attributes of numbers and points; values at
/// new vertices are linear in each face. New custom attributes: `on_curve` of vertices, 1 on
/// curves, and `parent` of faces, the surface's face that each is part of (-1: it fills a hole). In
/// a window the surface is hidden, since it would shine through, and several layers get the colours
/// of their parts unless the surface has colours or textures. Returns the layers' labels.
std::vector<std::string> addMadeLayers(
    MeshDocument& document, const SurfaceLayer& surface, const MeshesResult& result
);

/// Adds a layer for each line, named after the layer of its curve; the first becomes the current
/// one. They are marked as results, see markAsResult(). Selects the band where there is one.
void addOffsetLayers(
    MeshDocument& document,
    MeshModel& surface,
    const LayerArrays& arrays,
    const OffsetResult& result
);

}  // namespace bspline_curve
