// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/lines.h"
#include "bspline_curve/parts.h"
#include "bspline_curve/progress.h"
#include "filters/imprint_requests.h"
#include "filters/polyline_layers.h"
#include "filters/run_filters.h"

#include <string>
#include <vector>

// The filters that use curves, from arrays to arrays. All throw InputError, Cancelled,
// std::bad_alloc; see describeFailure().
namespace bspline_curve {

/// A mesh for a new layer.
struct MeshLayer {
    std::string suffix;  ///< follows the name of the surface's layer: " imprinted"
    MadeMesh made;
    bool showsParts = false;  ///< faces have their part as quality, and its colour
};

struct MeshesResult {
    std::vector<MeshLayer> layers;
    Figures figures;
    FilterLog log;
};

/// One layer with curves as edges.
[[nodiscard]] MeshesResult runImprintFilter(
    const CurvesOnLayer& input, const ImprintRequest& request, const Progress& progress = {}
);

/// The mesh opened along curves: in one layer, in one for each part, or a part of it. `toolPoints`:
/// see partChoice().
[[nodiscard]] MeshesResult runCutFilter(
    const CurvesOnLayer& input,
    const std::vector<Vec3>& toolPoints,
    const CutRequest& request,
    const Progress& progress = {}
);

/// One layer with holes closed that the mesh has; no curves are needed.
[[nodiscard]] MeshesResult runFillFilter(
    const CurvesOnLayer& input, const FillRequest& request, const Progress& progress = {}
);

/// Parts labelled, coloured and measured, in one layer or in one for each part. Refuses curves that
/// part nothing.
[[nodiscard]] MeshesResult runSegmentFilter(
    const CurvesOnLayer& input, const SegmentRequest& request, const Progress& progress = {}
);

struct OffsetResult {
    struct Piece {
        SurfacePolyline line;
        std::string curve;  ///< label of the layer that it is beside
    };

    std::vector<Piece> pieces;  ///< of each curve the longest first
    std::vector<char> band;     ///< per face of LayerInput, where the band is asked for
    Figures figures;
    FilterLog log;
};

/// Lines at a distance. Refuses a curve beside which no point has it.
[[nodiscard]] OffsetResult runOffsetFilter(
    const CurvesOnLayer& input, const OffsetRequest& request, const Progress& progress = {}
);

struct PointsResult {
    std::vector<CurvePoint> points;  ///< of all curves, one after the other
    std::vector<int> curveOf;        ///< of each point its curve, from 0
    Figures figures;
    FilterLog log;
};

/// Points along curves. Refuses a distance that is not on a curve, and one point of an open curve.
[[nodiscard]] PointsResult runPointsFilter(
    const CurvesOnLayer& input, const PointsRequest& request, const Progress& progress = {}
);

}  // namespace bspline_curve
