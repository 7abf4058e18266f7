// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/made_mesh.h"

#include "surface/surface_point.h"

#include <cstddef>
#include <utility>

namespace bspline_curve {

MadeMesh::MadeMesh(
    std::shared_ptr<const Surface> surface,
    std::shared_ptr<const ImprintedMesh> imprint,
    FilledParts taken
)
    : surface_(std::move(surface)), imprint_(std::move(imprint)), taken_(std::move(taken)) {}

int MadeMesh::vertexOf(int vertex) const {
    const int imprinted = taken_.origin[vertex];
    return imprinted < imprint_->inputVertexCount() ? imprinted : -1;
}

int MadeMesh::faceOf(int face) const {
    const int imprinted = taken_.faces[face];
    return imprinted < 0 ? -1 : imprint_->parents[imprinted];
}

Vec3 MadeMesh::placeOf(int face, int corner) const {
    const int parent = faceOf(face);
    const int vertex = taken_.origin[taken_.mesh.faces[face][corner]];
    const int old = imprint_->inputVertexCount();
    if (vertex < old) {
        return Vec3::Unit(cornerOf(surface_->faces()[parent], vertex));
    }
    return inFace(*surface_, imprint_->newVertices[vertex - old], parent).barycentric;
}

std::vector<double> MadeMesh::carried(std::span<const double> layerValues) const {
    return taken_.carried(interpolated(*imprint_, surface_->faces(), layerValues));
}

std::vector<double> MadeMesh::curveFlags() const {
    std::vector<double> isOnCurve(imprint_->mesh.vertices.size(), 0.0);
    for (const ImprintedCurve& curve : imprint_->curves) {
        for (const int vertex : curve.vertices) {
            isOnCurve[vertex] = 1.0;
        }
    }
    std::vector<double> flags;
    for (const int vertex : taken_.origin) {
        flags.push_back(vertex < 0 ? 0.0 : isOnCurve[vertex]);
    }
    return flags;
}

}  // namespace bspline_curve
