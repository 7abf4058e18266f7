// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/made_mesh.h"

#include "surface/surface_point.h"

#include <cstddef>
#include <utility>

namespace bspline_curve {

MadeMesh::MadeMesh(
    MendedSurface surface, std::shared_ptr<const ImprintedMesh> imprint, FilledParts taken
)
    : surface_(std::move(surface)), imprint_(std::move(imprint)), taken_(std::move(taken)) {}

int MadeMesh::vertexOf(int vertex) const {
    const int imprinted = taken_.origin[vertex];
    if (imprinted < 0 || imprinted >= imprint_->inputVertexCount()) {
        return -1;
    }
    const MeshRepair* const repair = surface_.repair();
    return repair == nullptr ? imprinted : repair->vertexOrigins[imprinted];
}

int MadeMesh::faceOf(int face) const {
    const int imprinted = taken_.faces[face];
    if (imprinted < 0) {
        return -1;
    }
    const int parent = imprint_->parents[imprinted];
    const MeshRepair* const repair = surface_.repair();
    return repair == nullptr ? parent : repair->faceOrigins[parent];
}

Vec3 MadeMesh::placeOf(int face, int corner) const {
    const Surface& surface = *surface_.surface;
    const int vertex = taken_.origin[taken_.mesh.faces[face][corner]];
    const int old = imprint_->inputVertexCount();
    SurfacePoint place{.face = imprint_->parents[taken_.faces[face]]};
    if (vertex < old) {
        place.barycentric = Vec3::Unit(cornerOf(surface.faces()[place.face], vertex));
    } else {
        place = inFace(surface, imprint_->newVertices[vertex - old], place.face);
    }
    const MeshRepair* const repair = surface_.repair();
    return repair == nullptr ? place.barycentric : repair->toOrigin(place).barycentric;
}

std::vector<double> MadeMesh::carried(std::span<const double> layerValues) const {
    const MeshRepair* const repair = surface_.repair();
    std::vector<double> mended;
    if (repair != nullptr) {
        mended = repair->carriedOver(std::vector(layerValues.begin(), layerValues.end()));
        layerValues = mended;
    }
    return taken_.carried(interpolated(*imprint_, surface_.surface->faces(), layerValues));
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
