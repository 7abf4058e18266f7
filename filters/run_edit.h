// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/progress.h"
#include "filters/edit_requests.h"
#include "filters/polyline_layers.h"
#include "filters/run_filters.h"
#include "filters/workpiece_cache.h"

#include <string>
#include <vector>

namespace bspline_curve {

struct EditResult {
    struct EditedCurve {
        Curve curve;        ///< in world coordinates, with the faces of the input
        std::string label;  ///< for its layer: "plate curve longer"
    };

    std::vector<EditedCurve> curves;
    std::vector<int> usedLayers;  ///< PolylineLayer::id of those that they are made of, ascending
    Figures figures;
    FilterLog log;
};

/// Curves turned round, cut, joined or made longer, see pieces.h. A layer that was drawn as a curve
/// has its spline; other polylines have themselves as one. Throws InputError, Cancelled,
/// std::bad_alloc.
[[nodiscard]] EditResult runEditFilter(
    const CurvesOnLayer& input,
    const EditRequest& request,
    WorkpieceCache& workpieces,
    const Progress& progress = {}
);

}  // namespace bspline_curve
