// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_bspline_curve/layer_mesh.h"

#include <common/mlexception.h>

#include <cmath>

namespace bspline_curve {

namespace {

/// World coordinates of a point of the layer; exactly its own ones where the matrix is the
/// identity.
class ToWorld {
public:
    explicit ToWorld(const Matrix44m& matrix)
        : matrix_(matrix), isIdentity_(matrix == Matrix44m::Identity()) {}

    [[nodiscard]] Vec3 operator()(const Point3m& p) const {
        return toVec3(isIdentity_ ? p : matrix_ * p);
    }

private:
    Matrix44m matrix_;
    bool isIdentity_;
};

void requireInvertible(const MeshModel& layer) {
    const double determinant = layer.cm.Tr.Determinant();
    if (!std::isfinite(determinant) || determinant == 0.0) {
        throw MLException(
            QString("the matrix of layer \"%1\" is singular: reset it, or freeze a valid one")
                .arg(layer.label())
        );
    }
}

}  // namespace

LayerMesh meshOf(const MeshModel& layer) {
    if (layer.cm.FN() == 0) {
        throw MLException(QString("layer \"%1\" has no faces: choose the layer of a triangle mesh")
                              .arg(layer.label()));
    }
    requireInvertible(layer);
    LayerMesh mesh;
    const ToWorld toWorld(layer.cm.Tr);
    std::vector<int> newIds(layer.cm.vert.size(), -1);
    for (std::size_t v = 0; v < layer.cm.vert.size(); ++v) {
        if (!layer.cm.vert[v].IsD()) {
            newIds[v] = static_cast<int>(mesh.vertexIds.size());
            mesh.vertexIds.push_back(static_cast<int>(v));
            mesh.world.vertices.push_back(toWorld(layer.cm.vert[v].cP()));
        }
    }
    for (std::size_t f = 0; f < layer.cm.face.size(); ++f) {
        const CFaceO& face = layer.cm.face[f];
        if (!face.IsD()) {
            const auto corner = [&](int k) {
                return newIds[vcg::tri::Index(layer.cm, face.cV(k))];
            };
            mesh.faceIds.push_back(static_cast<int>(f));
            mesh.world.faces.push_back({corner(0), corner(1), corner(2)});
        }
    }
    mesh.hasLayersIds = mesh.vertexIds.size() == layer.cm.vert.size() &&
                        mesh.faceIds.size() == layer.cm.face.size();
    return mesh;
}

std::vector<double> qualityOf(const MeshModel& layer, const LayerMesh& mesh) {
    if (!layer.hasPerVertexQuality()) {
        throw MLException(
            QString(
                "layer \"%1\" has no per-vertex quality: compute one first, or choose another field"
            )
                .arg(layer.label())
        );
    }
    std::vector<double> quality;
    quality.reserve(mesh.vertexIds.size());
    for (const int v : mesh.vertexIds) {
        quality.push_back(layer.cm.vert[static_cast<std::size_t>(v)].cQ());
    }
    return quality;
}

std::vector<Vec3> pointsOf(const MeshModel& layer) {
    std::vector<Vec3> points;
    const ToWorld toWorld(layer.cm.Tr);
    for (const CVertexO& vertex : layer.cm.vert) {
        if (!vertex.IsD()) {
            points.push_back(toWorld(vertex.cP()));
        }
    }
    return points;
}

}  // namespace bspline_curve
