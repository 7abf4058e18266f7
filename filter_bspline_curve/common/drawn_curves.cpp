// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_bspline_curve/common/drawn_curves.h"

#include "filter_bspline_curve/common/result_layers.h"
#include "filter_bspline_curve/common/window.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

namespace bspline_curve {

namespace {

std::vector<Vec3> picksOf(const SurfacePolyline& polyline) {
    std::vector<Vec3> picks;
    for (const int index : polyline.picks) {
        picks.push_back(polyline.points[static_cast<std::size_t>(index)]);
    }
    return picks;
}

}  // namespace

void DrawnCurves::show(
    MeshDocument& document,
    const MeshModel& surface,
    const LayerArrays& arrays,
    const CurveRequest& request,
    const CurveResult& result
) {
    if (!hasWindow()) {
        addResultLayers(document, surface, arrays, result);
        return;
    }
    const int surfaceId = surface.id();
    std::vector<Vec3> picks = picksOf(result.curve.polyline);
    if (request.replace) {
        removeMoved(document, surfaceId, picks);
    }
    std::vector<int> layers = addResultLayers(document, surface, arrays, result);
    drawn_.push_back({&document, surfaceId, std::move(picks), std::move(layers)});
    document.setCurrentMesh(surfaceId);
}

void DrawnCurves::removeMoved(MeshDocument& document, int surface, std::span<const Vec3> picks) {
    const auto isMoved = [&](const Drawn& drawn) {
        const auto shared = std::ranges::count_if(picks, [&](const Vec3& pick) {
            return std::ranges::find(drawn.picks, pick) != drawn.picks.end();
        });
        return drawn.document == &document && drawn.surface == surface &&
               2 * static_cast<std::size_t>(shared) >= picks.size();
    };
    const auto found = std::find_if(drawn_.rbegin(), drawn_.rend(), isMoved);
    if (found == drawn_.rend()) {
        return;
    }
    for (const int layer : found->layers) {
        if (host::layerWithId(document, layer) != nullptr) {
            host::removeLayer(document, layer);
        }
    }
    drawn_.erase(std::next(found).base());
}

}  // namespace bspline_curve
