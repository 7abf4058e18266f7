// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_bspline_curve/common/curve_layers.h"

#include "bspline_curve/error.h"
#include "filter_bspline_curve/common/curve_source.h"
#include "filter_bspline_curve/common/polyline_attributes.h"
#include "filter_bspline_curve/common/polyline_layer.h"
#include "filter_bspline_curve/common/surface_choice.h"
#include "utility/index_sets.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace bspline_curve {

namespace {

/// Empty where the layer has no such attributes.
std::vector<SurfacePoint> placesOf(const MeshModel& layer, const LayerArrays& arrays) {
    auto faces = vertexAttribute<Scalarm>(layer.cm, kFaceIndexAttribute);
    auto barycentrics = vertexAttribute<Point3m>(layer.cm, kBarycentricAttribute);
    std::vector<SurfacePoint> places;
    if (!faces || !barycentrics) {
        return places;
    }
    for (std::size_t v = 0; v < layer.cm.vert.size(); ++v) {
        if (!layer.cm.vert[v].IsD()) {
            const Vec3 weights = toVec3((*barycentrics)[v]);
            places.push_back({
                .face = indexIn(arrays.faceIds, static_cast<int>((*faces)[v])),
                .barycentric = weights / weights.sum()  // floats do not sum to 1
            });
        }
    }
    return places;
}

PolylineLayer polylineOf(const MeshModel& layer) {
    PolylineLayer polyline;
    polyline.label = layer.label().toStdString();
    polyline.id = layer.id();
    polyline.points = pointsOf(layer);
    std::vector<int> newIds(layer.cm.vert.size(), -1);
    int count = 0;
    for (std::size_t v = 0; v < newIds.size(); ++v) {
        newIds[v] = layer.cm.vert[v].IsD() ? -1 : count++;
    }
    for (const CEdgeO& edge : layer.cm.edge) {
        if (!edge.IsD()) {
            const auto end = [&](int k) { return newIds[vcg::tri::Index(layer.cm, edge.cV(k))]; };
            polyline.edges.push_back({end(0), end(1)});
        }
    }
    return polyline;
}

/// The layer that was chosen, or null where none was.
const MeshModel* chosenLayer(const MeshDocument& document, const CurveUse& use) {
    if (use.curve.id < 0 || use.curve == use.surface) {
        return nullptr;
    }
    const MeshModel& layer = layerNamed(document, use.curve, "curve_layer");
    if (isPolyline(layer)) {
        return &layer;
    }
    // Where another surface was chosen, the one that the host offered is still there.
    if (layer.cm.FN() > 0 && &layer == defaultSurface(document)) {
        return nullptr;
    }
    throw InputError(
        InputErrorCode::BadOption,
        "curve_layer: layer \"" + layer.label().toStdString() + "\" is no polyline: it has " +
            (layer.cm.FN() > 0 ? "faces" : "no edges") + "; choose a layer of a curve"
    );
}

/// The layers that are meant where none is chosen.
std::vector<const MeshModel*> usualLayers(const MeshDocument& document, const MeshModel& surface) {
    std::vector<const MeshModel*> curves;
    std::vector<const MeshModel*> results;
    std::vector<const MeshModel*> ofOthers;
    for (const MeshModel* const layer : host::layersOf(document)) {
        if (!layer->isVisible() || !isPolyline(*layer) || isOfCurve(*layer)) {
            continue;
        }
        const MeshModel* const drawnOn = surfaceOfCurve(document, *layer);
        if (drawnOn != nullptr && drawnOn != &surface) {
            ofOthers.push_back(layer);
        } else {
            (isResult(*layer) ? results : curves).push_back(layer);
        }
    }
    return !curves.empty() ? curves : !results.empty() ? results : ofOthers;
}

}  // namespace

std::vector<PolylineLayer> curvesFor(
    const MeshDocument& document,
    const MeshModel& surface,
    const LayerArrays& arrays,
    const CurveUse& use
) {
    std::vector<PolylineLayer> curves;
    const MeshModel* const chosen = chosenLayer(document, use);
    const std::vector<const MeshModel*> layers =
        chosen != nullptr ? std::vector{chosen} : usualLayers(document, surface);
    for (const MeshModel* const layer : layers) {
        PolylineLayer polyline = polylineOf(*layer);
        if (surfaceOfCurve(document, *layer) == &surface) {
            polyline.places = placesOf(*layer, arrays);
            const MeshChecksum* const checksum = checksumOfSurface(*layer);
            polyline.drawnOn = checksum == nullptr ? std::nullopt : std::optional(*checksum);
            const CurveSource* const source = sourceOf(*layer);
            polyline.drawn = source == nullptr ? nullptr : source->curve;
        } else {
            polyline.isOptional = chosen == nullptr;
        }
        curves.push_back(std::move(polyline));
    }
    return curves;
}

}  // namespace bspline_curve
