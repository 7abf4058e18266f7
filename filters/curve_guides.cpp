// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/curve_guides.h"

#include "bspline_curve/error.h"
#include "field/make_field.h"
#include "filters/automatic_field.h"
#include "filters/layer_ids.h"

#include <cstddef>
#include <span>

namespace bspline_curve {

namespace {

std::span<const double> qualityOf(const LayerInput& layer) {
    if (layer.quality.empty()) {
        throw InputError(
            InputErrorCode::BadField,
            "layer \"" + layer.label +
                "\" has no per-vertex quality: compute one first, or choose another field"
        );
    }
    return layer.quality;
}

Region selectedRegion(const LayerInput& layer, const Surface& surface, RegionSource source) {
    if (source == RegionSource::SelectedVertices) {
        return layer.selectedVertices.empty() ? Region()
                                              : facesOfVertices(surface, layer.selectedVertices);
    }
    Region region;
    for (std::size_t f = 0; f < layer.selectedFaces.size(); ++f) {
        if (layer.selectedFaces[f] != 0) {
            region.push_back(static_cast<int>(f));
        }
    }
    return region;
}

/// The faces to avoid. `field` is empty where there is none.
Region avoidedRegion(
    const CurveRequest& request,
    const LayerInput& layer,
    const Surface& surface,
    std::span<const double> field
) {
    const auto values = [&] { return field.empty() ? qualityOf(layer) : field; };
    switch (request.avoid) {
        case Avoid::SelectedFaces:
            return selectedRegion(layer, surface, RegionSource::SelectedFaces);
        case Avoid::SelectedVertices:
            return selectedRegion(layer, surface, RegionSource::SelectedVertices);
        case Avoid::UnderThreshold:
            return facesUnder(surface, values(), request.avoidThreshold);
        case Avoid::OverThreshold:
            return facesOver(surface, values(), request.avoidThreshold);
        case Avoid::Nothing:
            break;
    }
    return {};
}

}  // namespace

std::vector<double> fieldOf(
    const LayerInput& layer,
    const Surface& surface,
    const FieldRequest& request,
    const Progress& progress
) {
    std::span<const double> quality;
    Region region;
    if (request.options.kind == FieldKind::Quality) {
        quality = qualityOf(layer);
    } else if (request.options.kind == FieldKind::Obstacle) {
        region = selectedRegion(layer, surface, request.region);
    }
    return makeField(surface, request.options, {.quality = quality, .region = region}, progress);
}

CurveGuides curveGuides(
    const LayerInput& layer,
    const Surface& surface,
    const CurveRequest& request,
    const Progress& progress
) {
    CurveGuides guides;
    guides.hasField = request.field && (!request.field->automatic || canBeFollowed(layer.quality));
    if (guides.hasField) {
        guides.field =
            madeFrom(layer, [&] { return fieldOf(layer, surface, *request.field, progress); });
    }
    guides.avoid = avoidedRegion(request, layer, surface, guides.field);
    return guides;
}

}  // namespace bspline_curve
