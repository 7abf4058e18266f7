// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filter_bspline_curve/common/host_meshes.h"
#include "filter_bspline_curve/common/layer_arrays.h"
#include "filter_bspline_curve/common/polyline_layer.h"
#include "filters/run_curve_uses.h"
#include "filters/run_edit.h"
#include "host_document.h"

#include <string>
#include <vector>

namespace bspline_curve {

/// Adds a layer for each mesh, named after the surface's layer and under its matrix; the first
/// becomes the current one. Takes vertices and faces out of the meshes. In a window the surface is
/// hidden, since it would shine through. Returns the layers' labels.
std::vector<std::string> addMadeLayers(
    MeshDocument& document, const MeshModel& surface, const std::vector<HostMesh>& meshes
);

/// Adds a layer for each line, named after the layer of its curve; the first becomes the current
/// one. They are marked as results, see markAsResult(). Selects the band where there is one.
void addOffsetLayers(
    MeshDocument& document,
    MeshModel& surface,
    const LayerArrays& arrays,
    const OffsetResult& result
);

/// Adds a layer for each curve, with what it is kept by, and hides those that they are made of. The
/// first becomes the current one.
void addEditedLayers(
    MeshDocument& document,
    const MeshModel& surface,
    const LayerArrays& arrays,
    const EditResult& result
);

}  // namespace bspline_curve
