// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"
#include "filter_bspline_curve/common/layer_arrays.h"
#include "filters/requests.h"
#include "filters/run_filters.h"
#include "host_document.h"

#include <span>
#include <vector>

namespace bspline_curve {

/// Shows curves as layers, and knows which of them belong together.
class DrawnCurves {
public:
    /// Adds the layers of a result, see addResultLayers(). Where the request asks for it, those of
    /// the curve whose picks were moved go: the last on this surface that was drawn through at
    /// least half of these picks, to the bit. In a window the surface stays the current layer,
    /// where the next points are picked.
    void show(
        MeshDocument& document,
        const MeshModel& surface,
        const LayerArrays& arrays,
        const CurveRequest& request,
        const CurveResult& result
    );

private:
    struct Drawn {
        const MeshDocument* document = nullptr;
        int surface = -1;
        std::vector<Vec3> picks;  ///< in world coordinates
        std::vector<int> layers;
    };

    void removeMoved(MeshDocument& document, int surface, std::span<const Vec3> picks);

    std::vector<Drawn> drawn_;
};

}  // namespace bspline_curve
