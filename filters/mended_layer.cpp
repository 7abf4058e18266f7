// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/mended_layer.h"

#include "filters/curve_notes.h"
#include "filters/layer_ids.h"

#include <utility>
#include <vector>

namespace bspline_curve {

MendedSurface surfaceOf(const LayerInput& layer, const MendingOptions& options) {
    return madeFrom(layer, [&] {
        auto [surface, mending] = makeMended(layer.mesh, options, [](TriangleMesh mesh) {
            return std::make_shared<const Surface>(std::move(mesh));
        });
        return MendedSurface{
            .surface = std::move(surface),
            .mending = mending ? std::make_shared<const Mending>(*std::move(mending)) : nullptr
        };
    });
}

LayerInput carriedOver(const LayerInput& layer, const MeshRepair& repair) {
    LayerInput carried;
    carried.label = layer.label;
    carried.hasLayersIds = layer.hasLayersIds;
    if (!layer.quality.empty()) {
        carried.quality = repair.carriedOver(layer.quality);
    }
    if (!layer.selectedVertices.empty()) {
        carried.selectedVertices = repair.carriedOver(layer.selectedVertices);
    }
    if (!layer.selectedFaces.empty()) {
        carried.selectedFaces.reserve(repair.faceOrigins.size());
        for (const int origin : repair.faceOrigins) {
            carried.selectedFaces.push_back(layer.selectedFaces[origin]);
        }
    }
    return carried;
}

std::string describeMending(const Mending& mending) {
    return asSentence(mending.note()) +
           " This is done on a copy in memory; the layer is unchanged" +
           (mending.refusal ? ", and strict refuses such a mesh." : ".");
}

}  // namespace bspline_curve
