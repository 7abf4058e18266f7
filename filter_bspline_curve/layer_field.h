// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filter_bspline_curve/field_parameters.h"
#include "filter_bspline_curve/layer_mesh.h"
#include "surface/progress.h"
#include "surface/region.h"
#include "surface/surface.h"

#include <common/ml_document/mesh_model.h>

#include <QVariant>
#include <map>
#include <string>
#include <vector>

namespace bspline_curve {

/// A field on a layer, one value per vertex of `mesh`, which is the layer's and has become the
/// surface; quality and selection are taken from the layer. Throws MLException, InputError,
/// Cancelled.
[[nodiscard]] std::vector<double> fieldOf(
    const MeshModel& layer,
    const LayerMesh& mesh,
    const Surface& surface,
    const FieldRequest& request,
    const Progress& progress
);

/// The selected faces of a layer, or those all of whose vertices are selected.
[[nodiscard]] Region selectedRegion(
    const MeshModel& layer, const LayerMesh& mesh, const Surface& surface, RegionSource source
);

/// Makes a field the per-vertex quality of the layer and answers with its minimum, mean and
/// maximum.
std::map<std::string, QVariant> setQuality(
    MeshModel& layer, const LayerMesh& mesh, const std::vector<double>& field
);

}  // namespace bspline_curve
