// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/progress.h"
#include "filter_bspline_curve/common/layer_data.h"
#include "filters/run_curve_uses.h"

#include <memory>
#include <string>
#include <vector>

namespace bspline_curve {

/// A mesh of the host that only waits to be brought into a document as a layer.
struct HostMesh {
    std::string suffix;  ///< follows the name of the surface's layer
    int mask = MeshModel::MM_NONE;
    std::shared_ptr<CMeshO> mesh = std::make_shared<CMeshO>();  ///< without attributes
    Attributes vertexAttributes;
    Attributes faceAttributes;
};

/// Fills a mesh of the host for each mesh that was made from a surface's layer: with normals, and
/// with what the layer has per vertex, face and wedge; values at new vertices are linear in each
/// face. New attributes: `on_curve` of vertices, 1 on curves, and `parent` of faces, the layer's
/// face that each is part of (-1: it fills a hole). Several meshes get the colours of their parts
/// if `coloursParts`, unless the surface has colours or textures. Touches no document: any thread
/// may call it. Throws Cancelled.
[[nodiscard]] std::vector<HostMesh> hostMeshes(
    const std::vector<MeshLayer>& made,
    const LayerInput& input,
    const LayerArrays& ids,
    const LayerData& data,
    bool coloursParts,
    const Progress& progress
);

}  // namespace bspline_curve
