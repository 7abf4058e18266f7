// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_bspline_curve/common/layer_data.h"

#include "filter_bspline_curve/common/polyline_attributes.h"

namespace bspline_curve {

namespace {

using Allocator = vcg::tri::Allocator<CMeshO>;

/// One value for each of these elements of the layer.
template <class Value, class Get>
void take(const std::vector<int>& ids, std::vector<Value>& values, const Get& get) {
    values.reserve(ids.size());
    for (const int id : ids) {
        values.push_back(get(id));
    }
}

template <class Value>
void takeVertexAttributes(
    CMeshO& mesh, const std::vector<int>& ids, std::map<std::string, std::vector<Value>>& taken
) {
    std::vector<std::string> names;
    Allocator::GetAllPerVertexAttribute<Value>(mesh, names);
    for (const std::string& name : names) {
        auto values = Allocator::FindPerVertexAttribute<Value>(mesh, name);
        take(ids, taken[name], [&](int id) { return values[id]; });
    }
}

template <class Value>
void takeFaceAttributes(
    CMeshO& mesh, const std::vector<int>& ids, std::map<std::string, std::vector<Value>>& taken
) {
    std::vector<std::string> names;
    Allocator::GetAllPerFaceAttribute<Value>(mesh, names);
    for (const std::string& name : names) {
        auto values = Allocator::FindPerFaceAttribute<Value>(mesh, name);
        take(ids, taken[name], [&](int id) { return values[id]; });
    }
}

int maskOf(const MeshModel& layer) {
    int mask = MeshModel::MM_NONE;
    for (const int data :
         {MeshModel::MM_VERTQUALITY,
          MeshModel::MM_VERTCOLOR,
          MeshModel::MM_VERTTEXCOORD,
          MeshModel::MM_FACEQUALITY,
          MeshModel::MM_FACECOLOR,
          MeshModel::MM_WEDGTEXCOORD}) {
        mask |= layer.hasDataMask(data) ? data : 0;
    }
    return mask;
}

}  // namespace

LayerData dataOf(const MeshModel& layer, const LayerArrays& arrays) {
    const auto& vertices = layer.cm.vert;
    const auto& faces = layer.cm.face;
    const std::vector<int>& vertexIds = arrays.vertexIds;
    const std::vector<int>& faceIds = arrays.faceIds;
    LayerData data;
    data.mask = maskOf(layer);
    data.toWorld = layer.cm.Tr;
    take(vertexIds, data.positions, [&](int id) { return vertices[id].cP(); });
    if (data.has(MeshModel::MM_VERTQUALITY)) {
        take(vertexIds, data.vertexQuality, [&](int id) { return vertices[id].cQ(); });
    }
    if (data.has(MeshModel::MM_VERTCOLOR)) {
        take(vertexIds, data.vertexColours, [&](int id) { return vertices[id].cC(); });
    }
    if (data.has(MeshModel::MM_VERTTEXCOORD)) {
        take(vertexIds, data.vertexTextures, [&](int id) { return vertices[id].cT(); });
    }
    if (data.has(MeshModel::MM_FACEQUALITY)) {
        take(faceIds, data.faceQuality, [&](int id) { return faces[id].cQ(); });
    }
    if (data.has(MeshModel::MM_FACECOLOR)) {
        take(faceIds, data.faceColours, [&](int id) { return faces[id].cC(); });
    }
    if (data.has(MeshModel::MM_WEDGTEXCOORD)) {
        take(faceIds, data.wedgeTextures, [&](int id) {
            const CFaceO& face = faces[id];
            return std::array{face.cWT(0), face.cWT(1), face.cWT(2)};
        });
    }
    CMeshO& mesh = forLookup(layer.cm);
    takeVertexAttributes(mesh, vertexIds, data.vertexAttributes.numbers);
    takeVertexAttributes(mesh, vertexIds, data.vertexAttributes.points);
    takeFaceAttributes(mesh, faceIds, data.faceAttributes.numbers);
    takeFaceAttributes(mesh, faceIds, data.faceAttributes.points);
    return data;
}

}  // namespace bspline_curve
