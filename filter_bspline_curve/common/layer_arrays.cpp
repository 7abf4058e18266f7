// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_bspline_curve/common/layer_arrays.h"

#include "bspline_curve/error.h"

#include <Eigen/LU>

#include <cmath>
#include <cstddef>

namespace bspline_curve {

namespace {

Eigen::Matrix4d matrixOf(const MeshModel& layer) {
    Eigen::Matrix4d matrix;
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) {
            matrix(row, column) = double(layer.cm.Tr.ElementAt(row, column));
        }
    }
    return matrix;
}

void addVertices(LayerArrays& arrays, const MeshModel& layer, std::vector<int>& newIds) {
    const ToWorld toWorld(layer);
    if (!toWorld.isInvertible()) {
        throw InputError(
            InputErrorCode::NonFiniteCoordinate,
            "the matrix of layer \"" + arrays.input.label +
                "\" is singular: reset it, or freeze a valid one"
        );
    }
    const bool hasQuality = host::hasQuality(layer);
    for (std::size_t v = 0; v < layer.cm.vert.size(); ++v) {
        const CVertexO& vertex = layer.cm.vert[v];
        if (vertex.IsD()) {
            continue;
        }
        newIds[v] = static_cast<int>(arrays.vertexIds.size());
        arrays.vertexIds.push_back(static_cast<int>(v));
        arrays.input.mesh.vertices.push_back(toWorld(toVec3(vertex.cP())));
        if (!toWorld.isIdentity()) {
            arrays.own.push_back(toVec3(vertex.cP()));
        }
        arrays.input.selectedVertices.push_back(vertex.IsS() ? 1 : 0);
        if (hasQuality) {
            arrays.input.quality.push_back(double(vertex.cQ()));
        }
    }
}

void addFaces(LayerArrays& arrays, const MeshModel& layer, const std::vector<int>& newIds) {
    for (std::size_t f = 0; f < layer.cm.face.size(); ++f) {
        const CFaceO& face = layer.cm.face[f];
        if (face.IsD()) {
            continue;
        }
        const auto corner = [&](int k) { return newIds[vcg::tri::Index(layer.cm, face.cV(k))]; };
        arrays.faceIds.push_back(static_cast<int>(f));
        arrays.input.mesh.faces.push_back({corner(0), corner(1), corner(2)});
        arrays.input.selectedFaces.push_back(face.IsS() ? 1 : 0);
    }
}

}  // namespace

ToWorld::ToWorld(const MeshModel& layer)
    : matrix_(matrixOf(layer)), isIdentity_(matrix_ == Eigen::Matrix4d::Identity()) {}

bool ToWorld::isInvertible() const {
    const double determinant = matrix_.determinant();
    return std::isfinite(determinant) && determinant != 0.0;
}

LayerArrays arraysOf(const MeshModel& layer) {
    LayerArrays arrays;
    arrays.input.label = layer.label().toStdString();
    if (layer.cm.FN() == 0) {
        throw InputError(
            InputErrorCode::EmptyMesh,
            "layer \"" + arrays.input.label + "\" has no faces: choose the layer of a triangle mesh"
        );
    }
    std::vector<int> newIds(layer.cm.vert.size(), -1);
    addVertices(arrays, layer, newIds);
    addFaces(arrays, layer, newIds);
    arrays.input.hasLayersIds = arrays.vertexIds.size() == layer.cm.vert.size() &&
                                arrays.faceIds.size() == layer.cm.face.size();
    return arrays;
}

MeshChecksum checksumOf(const MeshModel& layer) {
    MeshChecksumBuilder builder;
    std::vector<int> newIds(layer.cm.vert.size(), -1);
    int count = 0;
    for (std::size_t v = 0; v < layer.cm.vert.size(); ++v) {
        if (!layer.cm.vert[v].IsD()) {
            newIds[v] = count++;
            builder.addVertex(toVec3(layer.cm.vert[v].cP()));
        }
    }
    for (const CFaceO& face : layer.cm.face) {
        if (!face.IsD()) {
            const auto corner = [&](int k) {
                return newIds[vcg::tri::Index(layer.cm, face.cV(k))];
            };
            builder.addFace({corner(0), corner(1), corner(2)});
        }
    }
    return builder.checksum();
}

MeshChecksum checksumOf(const LayerArrays& arrays) {
    MeshChecksumBuilder builder;
    for (const Vec3& vertex : arrays.own.empty() ? arrays.input.mesh.vertices : arrays.own) {
        builder.addVertex(vertex);
    }
    for (const Triangle& face : arrays.input.mesh.faces) {
        builder.addFace(face);
    }
    return builder.checksum();
}

std::vector<Vec3> pointsOf(const MeshModel& layer) {
    std::vector<Vec3> points;
    const ToWorld toWorld(layer);
    for (const CVertexO& vertex : layer.cm.vert) {
        if (!vertex.IsD()) {
            points.push_back(toWorld(toVec3(vertex.cP())));
        }
    }
    return points;
}

}  // namespace bspline_curve
