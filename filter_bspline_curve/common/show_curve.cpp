// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_bspline_curve/common/show_curve.h"

#include "filter_bspline_curve/common/curve_source.h"
#include "filter_bspline_curve/common/result_layers.h"
#include "filter_bspline_curve/common/window.h"

namespace bspline_curve {

void showCurve(
    MeshDocument& document,
    const MeshModel& surface,
    const LayerArrays& arrays,
    const CurveRequest& request,
    const CurveResult& result
) {
    const int surfaceId = surface.id();
    if (request.replace) {
        const int old = curveOfPicks(document, surfaceId, pickPositions(result.curve));
        if (old >= 0) {
            removeCurve(document, old);
        }
    }
    addResultLayers(document, surface, arrays, request, result);
    if (hasWindow()) {
        document.setCurrentMesh(surfaceId);
    }
}

}  // namespace bspline_curve
