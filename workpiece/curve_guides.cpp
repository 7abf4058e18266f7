// SPDX-License-Identifier: GPL-3.0-or-later
#include "workpiece/curve_guides.h"

#include "bspline_curve/curve_options.h"
#include "bspline_curve/error.h"
#include "field/make_field.h"
#include "surface/surface_point.h"
#include "utility/index_sets.h"
#include "workpiece/layer_ids.h"

#include <cstddef>
#include <span>

namespace bspline_curve {

namespace {

std::span<const double> qualityOf(const LayerInput& layer) {
    if (layer.quality.empty()) {
        throw InputError(
            InputErrorCode::BadField,
            layer.name() +
                (layer.isFile ? " has no per-vertex quality of type float or double (only .ply can)"
                              : " has no per-vertex quality: compute one first, or choose another "
                                "field")
        );
    }
    return layer.quality;
}

/// `values`: of thresholds; empty: the quality.
Region facesOf(
    const FaceChoice& choice,
    const LayerInput& layer,
    const TriangleMesh& mesh,
    std::span<const double> values
) {
    using By = FaceChoice::By;
    if (choice.hasThreshold() && values.empty()) {
        values = qualityOf(layer);
    }
    switch (choice.by) {
        case By::Ids:
            return choice.ids;
        case By::SelectedFaces:
            return indicesWhere<int>(layer.selectedFaces.size(), [&](std::size_t f) {
                return layer.selectedFaces[f] != 0;
            });
        case By::SelectedVertices:
            return layer.selectedVertices.empty() ? Region()
                                                  : facesOfVertices(mesh, layer.selectedVertices);
        case By::UnderThreshold:
            return facesUnder(mesh, values, choice.threshold);
        case By::OverThreshold:
            return facesOver(mesh, values, choice.threshold);
        case By::Nothing:
            break;
    }
    return {};
}

}  // namespace

ScalarField fieldOf(
    const LayerInput& layer,
    const Surface& surface,
    const FieldRequest& request,
    const Progress& progress
) {
    std::span<const double> quality;
    Region region;
    if (request.options.kind == FieldKind::Quality) {
        quality = request.values.empty() ? qualityOf(layer) : std::span(request.values);
    } else if (request.options.kind == FieldKind::Obstacle) {
        region = facesOf(request.region, layer, surface.input(), {});
    }
    return madeFrom(layer, [&] {
        return makeField(
            surface, request.options, {.quality = quality, .region = region}, progress
        );
    });
}

CurveGuides curveGuides(
    const LayerInput& layer,
    const Surface& surface,
    const CurveOptions& options,
    const Progress& progress
) {
    CurveGuides guides;
    if (options.field && (!options.field->automatic || canBeFollowed(layer.quality))) {
        guides.field = fieldOf(layer, surface, *options.field, progress);
    }
    guides.avoid = facesOf(options.avoid, layer, surface.input(), guides.field.values());
    return guides;
}

std::vector<double> fieldAlong(
    const SurfacePolyline& polyline,
    const std::vector<Triangle>& faces,
    std::span<const double> field
) {
    std::vector<double> values;
    values.reserve(polyline.surfacePoints.size());
    for (const SurfacePoint& point : polyline.surfacePoints) {
        values.push_back(valueAt(faces, field, point));
    }
    return values;
}

}  // namespace bspline_curve
