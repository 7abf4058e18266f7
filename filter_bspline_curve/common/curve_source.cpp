// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_bspline_curve/common/curve_source.h"

#include "bspline_curve/spline.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

namespace bspline_curve {

namespace {

using Allocator = vcg::tri::Allocator<CMeshO>;

const std::string kSource = "bspline_curve_source";
const std::string kOfCurve = "bspline_curve_of_curve";
const std::string kResult = "bspline_curve_result";

/// Without options.
CurveSource sourceFor(const MeshModel& surface, const LayerArrays& arrays, const Curve& curve) {
    CurveSource source;
    source.surface = surface.id();
    source.picks = pickPointsOf(curve);
    for (SurfacePoint& pick : source.picks) {
        pick.face = arrays.faceIds[pick.face];
    }
    source.positions = pickPositions(curve);
    source.corners = cornersOf(curve.spline);
    source.tangents = tangentsAtPicks(curve);
    source.closed = curve.polyline.closed;
    source.curve = std::make_shared<const Curve>(curve);
    source.toWorld = surface.cm.Tr;
    return source;
}

}  // namespace

void keepSource(
    MeshModel& curve,
    const MeshModel& surface,
    const LayerArrays& arrays,
    const CurveRequest& request,
    const CurveResult& result
) {
    CurveSource source = sourceFor(surface, arrays, result.curve);
    source.options = drawnOptions(request);
    keepSource(curve, std::move(source));
}

void keepSource(
    MeshModel& curve, const MeshModel& surface, const LayerArrays& arrays, const Curve& made
) {
    keepSource(curve, sourceFor(surface, arrays, made));
}

void keepSource(MeshModel& curve, CurveSource source) {
    Allocator::GetPerMeshAttribute<CurveSource>(curve.cm, kSource)() = std::move(source);
}

std::vector<SurfacePoint> pickPointsOf(const Curve& curve) {
    std::vector<SurfacePoint> picks = curve.nearPicks;
    if (picks.empty()) {
        for (const int index : curve.polyline.picks) {
            picks.push_back(curve.polyline.surfacePoints[index]);
        }
    }
    return picks;
}

std::vector<Vec3> pickPositions(const Curve& curve) {
    std::vector<Vec3> positions = curve.nearPickPositions;
    if (positions.empty()) {
        for (const int index : curve.polyline.picks) {
            positions.push_back(curve.polyline.points[index]);
        }
    }
    return positions;
}

const CurveSource* sourceOf(const MeshModel& layer) {
    return host::perMeshAttribute<CurveSource>(layer.cm, kSource);
}

std::optional<CurveColour> colourOf(const MeshModel& layer) {
    if (!layer.hasDataMask(MeshModel::MM_VERTCOLOR) || layer.cm.vert.empty()) {
        return std::nullopt;
    }
    const vcg::Color4b& colour = layer.cm.vert.front().cC();
    return CurveColour{colour[0], colour[1], colour[2], colour[3]};
}

void attachToCurve(MeshModel& layer, const MeshModel& curve) {
    Allocator::AddPerMeshAttribute<int>(layer.cm, kOfCurve)() = curve.id();
}

bool isOfCurve(const MeshModel& layer) {
    return host::perMeshAttribute<int>(layer.cm, kOfCurve) != nullptr;
}

std::vector<int> layersOfCurve(const MeshDocument& document, int curve) {
    std::vector<int> layers;
    for (const MeshModel* const layer : host::layersOf(document)) {
        const int* const id = host::perMeshAttribute<int>(layer->cm, kOfCurve);
        if (layer->id() == curve || (id != nullptr && *id == curve)) {
            layers.push_back(layer->id());
        }
    }
    return layers;
}

void markAsResult(MeshModel& layer) {
    Allocator::AddPerMeshAttribute<int>(layer.cm, kResult)() = 1;
}

bool isResult(const MeshModel& layer) {
    return host::perMeshAttribute<int>(layer.cm, kResult) != nullptr;
}

void setCurveVisible(MeshDocument& document, int curve, bool isVisible) {
    for (const int layer : layersOfCurve(document, curve)) {
        document.setVisible(layer, isVisible);
    }
}

void removeCurve(MeshDocument& document, int curve) {
    for (const int layer : layersOfCurve(document, curve)) {
        host::removeLayer(document, layer);
    }
}

int curveOfPicks(const MeshDocument& document, int surface, std::span<const Vec3> picks) {
    int newest = -1;
    for (const MeshModel* const layer : host::layersOf(document)) {
        const CurveSource* const source = sourceOf(*layer);
        if (source == nullptr || source->surface != surface) {
            continue;
        }
        const auto shared = std::ranges::count_if(picks, [&](const Vec3& pick) {
            return std::ranges::find(source->positions, pick) != source->positions.end();
        });
        if (2 * static_cast<std::size_t>(shared) >= picks.size()) {
            newest = std::max(newest, layer->id());
        }
    }
    return newest;
}

}  // namespace bspline_curve
