// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/parts.h"
#include "imprint/imprint.h"
#include "workpiece/imprint_source.h"

#include <cstddef>
#include <utility>

namespace bspline_curve {

MadeMesh::MadeMesh(const Imprint& imprint, FilledParts taken)
    : source_(imprint.source),
      joined_(imprint.joined),
      imprint_(imprint.mesh),
      taken_(std::move(taken)) {}

int MadeMesh::vertexOf(int vertex) const {
    const int imprinted = taken_.source[vertex];
    if (imprinted < 0 || taken_.mesh.vertices[vertex] != imprint_->mesh.vertices[imprinted]) {
        return -1;  // new, or moved by a relief or wall
    }
    const auto inputCount = static_cast<int>(source_->surface->input().vertices.size());
    return imprinted < inputCount ? imprinted : imprint_->doubledVertices[imprinted - inputCount];
}

int MadeMesh::faceOf(int face) const {
    const int imprinted = taken_.faces[face];
    return imprinted < 0 ? -1 : imprint_->parents[imprinted];
}

Vec3 MadeMesh::placeOf(int face, int corner) const {
    const SurfacePoint place = ownPlace(*source_->surface, *joined_, taken_.faces[face], corner);
    return source_->surface->provenance().toInput(place).barycentric;
}

std::vector<double> MadeMesh::carried(std::span<const double> values) const {
    return taken_.carried(interpolated(*imprint_, source_->surface->input().faces, values));
}

std::vector<double> MadeMesh::curveFlags() const {
    std::vector<char> isOnCurve(joined_->mesh.vertices.size(), 0);
    for (const ImprintedCurve& curve : joined_->curves) {
        for (const int vertex : curve.vertices) {
            isOnCurve[vertex] = 1;
        }
    }
    std::vector<double> flags(taken_.mesh.vertices.size(), 0.0);
    for (std::size_t f = 0; f < taken_.faces.size(); ++f) {
        for (int k = 0; taken_.faces[f] >= 0 && k < 3; ++k) {
            if (isOnCurve[joined_->mesh.faces[taken_.faces[f]][k]] != 0) {
                flags[taken_.mesh.faces[f][k]] = 1.0;
            }
        }
    }
    return flags;
}

}  // namespace bspline_curve
