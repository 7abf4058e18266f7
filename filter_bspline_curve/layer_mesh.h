// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/types.h"

#include <common/ml_document/mesh_model.h>

#include <vector>

namespace bspline_curve {

/// A layer as plain arrays, without its deleted elements. The layer itself is not changed.
struct LayerMesh {
    TriangleMesh world;          ///< in world coordinates: the layer's matrix is applied
    std::vector<int> vertexIds;  ///< index in the layer of each vertex
    std::vector<int> faceIds;    ///< index in the layer of each face
    bool hasLayersIds = true;    ///< nothing was deleted: the arrays' indices are the layer's
};

/// Throws MLException where the layer has no faces or its matrix is singular.
[[nodiscard]] LayerMesh meshOf(const MeshModel& layer);

/// Per-vertex quality of the vertices of the mesh. Throws MLException where the layer has none.
[[nodiscard]] std::vector<double> qualityOf(const MeshModel& layer, const LayerMesh& mesh);

/// Vertices of a layer in order, without deleted ones, in world coordinates.
[[nodiscard]] std::vector<Vec3> pointsOf(const MeshModel& layer);

[[nodiscard]] inline Vec3 toVec3(const Point3m& p) {
    return {p[0], p[1], p[2]};
}

[[nodiscard]] inline Point3m toPoint3m(const Vec3& v) {
    return {v[0], v[1], v[2]};
}

}  // namespace bspline_curve
