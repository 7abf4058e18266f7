// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_bspline_curve/common/made_layers.h"

#include "filter_bspline_curve/common/curve_source.h"
#include "filter_bspline_curve/common/layer_making.h"
#include "filter_bspline_curve/common/window.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace bspline_curve {

namespace {

using Allocator = vcg::tri::Allocator<CMeshO>;

/// Lets an empty mesh have the vertices and faces of another one, where they are in memory.
void handOver(CMeshO& from, CMeshO& to) {
    std::swap(from.vert, to.vert);
    std::swap(from.face, to.face);
    to.vert._updateOVP(to.vert.begin(), to.vert.end());
    to.face._updateOVP(to.face.begin(), to.face.end());
    std::swap(from.vn, to.vn);
    std::swap(from.fn, to.fn);
}

template <class Value>
void addVertexAttributes(const std::map<std::string, std::vector<Value>>& all, CMeshO& mesh) {
    for (const auto& [name, values] : all) {
        auto to = Allocator::GetPerVertexAttribute<Value>(mesh, name);
        for (std::size_t i = 0; i < values.size(); ++i) {
            to[i] = values[i];
        }
    }
}

template <class Value>
void addFaceAttributes(const std::map<std::string, std::vector<Value>>& all, CMeshO& mesh) {
    for (const auto& [name, values] : all) {
        auto to = Allocator::GetPerFaceAttribute<Value>(mesh, name);
        for (std::size_t f = 0; f < values.size(); ++f) {
            to[f] = values[f];
        }
    }
}

void selectBand(MeshModel& surface, const LayerArrays& arrays, const std::vector<char>& band) {
    for (CFaceO& face : surface.cm.face) {
        if (!face.IsD()) {
            face.ClearS();
        }
    }
    for (std::size_t f = 0; f < band.size(); ++f) {
        if (band[f] != 0) {
            surface.cm.face[arrays.faceIds[f]].SetS();
        }
    }
}

}  // namespace

std::vector<std::string> addMadeLayers(
    MeshDocument& document, const MeshModel& surface, const std::vector<HostMesh>& meshes
) {
    std::vector<const MeshModel*> layers;
    for (const HostMesh& filled : meshes) {
        const QString name = nameOf(surface) + QString::fromStdString(filled.suffix);
        MeshModel& layer = *document.addNewMesh("", name, layers.empty());
        layer.updateDataMask(filled.mask);
        handOver(*filled.mesh, layer.cm);
        addVertexAttributes(filled.vertexAttributes.numbers, layer.cm);
        addVertexAttributes(filled.vertexAttributes.points, layer.cm);
        addFaceAttributes(filled.faceAttributes.numbers, layer.cm);
        addFaceAttributes(filled.faceAttributes.points, layer.cm);
        host::copyTextures(surface, layer);
        attachTo(surface, layer);
        layers.push_back(&layer);
    }
    if (hasWindow()) {
        document.setVisible(surface.id(), false);
    }
    std::vector<std::string> labels;  // MeshLab changes names that are taken
    for (const MeshModel* const layer : layers) {
        labels.push_back(layer->label().toStdString());
    }
    return labels;
}

void addOffsetLayers(
    MeshDocument& document,
    MeshModel& surface,
    const LayerArrays& arrays,
    const OffsetResult& result
) {
    std::map<std::string, int> pieces;  // of each curve so far
    for (std::size_t i = 0; i < result.pieces.size(); ++i) {
        const auto& [line, curve] = result.pieces[i];
        const int piece = ++pieces[curve];
        QString name = QString::fromStdString(curve) + " offset";
        name += piece > 1 ? QString(" %1").arg(piece) : QString();
        markAsResult(addPolylineLayer(
            document,
            {surface, arrays},
            line,
            {.name = name, .quality = line.parameters, .isCurrent = i == 0}
        ));
    }
    if (!result.band.empty()) {
        selectBand(surface, arrays, result.band);
    }
}

void addEditedLayers(
    MeshDocument& document,
    const MeshModel& surface,
    const LayerArrays& arrays,
    const EditResult& result
) {
    for (std::size_t i = 0; i < result.curves.size(); ++i) {
        const auto& [curve, label] = result.curves[i];
        const SurfacePolyline& line = curve.polyline;
        MeshModel& layer = addPolylineLayer(
            document,
            {surface, arrays},
            line,
            {.name = QString::fromStdString(label), .quality = line.parameters, .isCurrent = i == 0}
        );
        keepSource(layer, surface, arrays, curve);
    }
    for (const int layer : result.usedLayers) {
        setCurveVisible(document, layer, false);
    }
}

}  // namespace bspline_curve
