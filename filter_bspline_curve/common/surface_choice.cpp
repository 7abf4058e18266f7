// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_bspline_curve/common/surface_choice.h"

#include "bspline_curve/error.h"
#include "filter_bspline_curve/common/curve_source.h"
#include "filter_bspline_curve/common/layer_arrays.h"
#include "filter_bspline_curve/common/picked_points.h"
#include "filter_bspline_curve/common/window.h"

#include <string>

namespace bspline_curve {

namespace {

const MeshModel* onlySurface(const MeshDocument& document) {
    const MeshModel* found = nullptr;
    for (const MeshModel* layer : host::layersOf(document)) {
        if (layer->cm.FN() > 0 && !isOfCurve(*layer)) {
            if (found != nullptr) {
                return nullptr;
            }
            found = layer;
        }
    }
    return found;
}

}  // namespace

bool isPolyline(const MeshModel& layer) {
    return layer.cm.FN() == 0 && layer.cm.EN() > 0;
}

const MeshModel* surfaceOfCurve(const MeshDocument& document, const MeshModel& layer) {
    const int* const id = host::perMeshAttribute<int>(layer.cm, kSurfaceLayerAttribute);
    return id == nullptr ? nullptr : host::layerWithId(document, *id);
}

const MeshModel& layerNamed(
    const MeshDocument& document, const LayerId& layer, const char* parameter
) {
    const MeshModel* found = host::layerWithId(document, layer.id);
    if (found == nullptr) {
        throw InputError(
            InputErrorCode::BadOption,
            std::string(parameter) + ": there is no layer " + std::to_string(layer.id)
        );
    }
    return *found;
}

const MeshModel* defaultSurface(const MeshDocument& document) {
    const MeshModel* current = document.mm();
    if (current == nullptr || (current->cm.FN() > 0 && !isOfCurve(*current))) {
        return current;
    }
    if (const MeshModel* surface = surfaceOfCurve(document, *current)) {
        return surface;
    }
    const MeshModel* only = onlySurface(document);
    return only == nullptr ? current : only;
}

const MeshModel* defaultCurves(const MeshDocument& document) {
    const MeshModel* const current = document.mm();
    const bool isCurve = current != nullptr && isPolyline(*current) && !isOfCurve(*current);
    return isCurve && hasWindow() ? current : defaultSurface(document);
}

const MeshModel& surfaceOf(const MeshDocument& document, const CurveRequest& request) {
    return layerNamed(document, request.surface, "surface_layer");
}

PickCandidates pickCandidates(
    const MeshDocument& document, const MeshModel& surface, const CurveRequest& request
) {
    PickCandidates candidates;
    for (const Point3m& point : pickedPointsOf(surface.cm)) {
        candidates.tool.push_back(toVec3(point));
    }
    if (request.picksLayer.id >= 0 && !(request.picksLayer == request.surface)) {
        const MeshModel& layer = layerNamed(document, request.picksLayer, "picks_layer");
        candidates.layer = PicksLayer{
            .label = layer.label().toStdString(),
            .points = pointsOf(layer),
            .hasFaces = layer.cm.FN() > 0,
            .isOffered = &layer == defaultSurface(document),
        };
    }
    return candidates;
}

}  // namespace bspline_curve
