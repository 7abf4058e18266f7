// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_bspline_curve/layer_field.h"

#include "field/make_field.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace bspline_curve {

Region selectedRegion(
    const MeshModel& layer, const LayerMesh& mesh, const Surface& surface, RegionSource source
) {
    if (source == RegionSource::SelectedVertices) {
        std::vector<char> selected;
        for (const int v : mesh.vertexIds) {
            selected.push_back(layer.cm.vert[static_cast<std::size_t>(v)].IsS() ? 1 : 0);
        }
        return facesOfVertices(surface, selected);
    }
    Region region;
    for (std::size_t f = 0; f < mesh.faceIds.size(); ++f) {
        if (layer.cm.face[static_cast<std::size_t>(mesh.faceIds[f])].IsS()) {
            region.push_back(static_cast<int>(f));
        }
    }
    return region;
}

std::vector<double> fieldOf(
    const MeshModel& layer,
    const LayerMesh& mesh,
    const Surface& surface,
    const FieldRequest& request,
    const Progress& progress
) {
    std::vector<double> quality;
    Region region;
    if (request.options.kind == FieldKind::Quality) {
        quality = qualityOf(layer, mesh);
    } else if (request.options.kind == FieldKind::Obstacle) {
        region = selectedRegion(layer, mesh, surface, request.region);
    }
    return makeField(surface, request.options, {.quality = quality, .region = region}, progress);
}

std::map<std::string, QVariant> setQuality(
    MeshModel& layer, const LayerMesh& mesh, const std::vector<double>& field
) {
    layer.updateDataMask(MeshModel::MM_VERTQUALITY);
    for (std::size_t i = 0; i < field.size(); ++i) {
        layer.cm.vert[static_cast<std::size_t>(mesh.vertexIds[i])].Q() = field[i];
    }
    const auto [minimum, maximum] = std::ranges::minmax(field);
    const double sum = std::accumulate(field.begin(), field.end(), 0.0);
    return {
        {"minimum", minimum},
        {"mean", sum / static_cast<double>(field.size())},
        {"maximum", maximum},
    };
}

}  // namespace bspline_curve
