// SPDX-License-Identifier: GPL-3.0-or-later
#include "workpiece/made_mesh.h"

#include "surface/surface_point.h"

#include <cstddef>
#include <utility>

namespace bspline_curve {

MadeMesh::MadeMesh(
    std::shared_ptr<const Workpiece> workpiece,
    std::shared_ptr<const ImprintedMesh> imprint,
    FilledParts taken
)
    : workpiece_(std::move(workpiece)), imprint_(std::move(imprint)), taken_(std::move(taken)) {}

int MadeMesh::vertexOf(int vertex) const {
    const int imprinted = taken_.source[vertex];
    if (imprinted < 0 || imprinted >= imprint_->surfaceVertexCount) {
        return -1;
    }
    return workpiece_->surface().provenance().inputVertex(imprinted);
}

int MadeMesh::faceOf(int face) const {
    const int imprinted = taken_.faces[face];
    return imprinted < 0 ? -1 : imprint_->parents[imprinted];
}

Vec3 MadeMesh::placeOf(int face, int corner) const {
    const Surface& surface = workpiece_->surface();
    const int vertex = taken_.source[taken_.mesh.faces[face][corner]];
    const int own = imprint_->ownParents[taken_.faces[face]];
    SurfacePoint place{.face = own};
    if (vertex < imprint_->surfaceVertexCount) {
        place.barycentric = Vec3::Unit(cornerOf(surface.faces()[own], vertex));
    } else {
        place = inFace(surface, imprint_->ownPlaces[vertex - imprint_->surfaceVertexCount], own);
    }
    return surface.provenance().toInput(place).barycentric;
}

std::vector<double> MadeMesh::carried(std::span<const double> values) const {
    return taken_.carried(interpolated(*imprint_, workpiece_->mesh().faces, values));
}

std::vector<double> MadeMesh::curveFlags() const {
    std::vector<double> isOnCurve(imprint_->mesh.vertices.size(), 0.0);
    for (const ImprintedCurve& curve : imprint_->curves) {
        for (const int vertex : curve.vertices) {
            isOnCurve[vertex] = 1.0;
        }
    }
    std::vector<double> flags;
    for (const int vertex : taken_.source) {
        flags.push_back(vertex < 0 ? 0.0 : isOnCurve[vertex]);
    }
    return flags;
}

}  // namespace bspline_curve
