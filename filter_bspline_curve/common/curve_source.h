// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"
#include "filter_bspline_curve/common/layer_arrays.h"
#include "filters/drawn_curve.h"
#include "filters/requests.h"
#include "filters/run_filters.h"
#include "host_document.h"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace bspline_curve {

/// What a curve was drawn from. Its layer keeps it, so that it can be drawn again.
struct CurveSource {
    int surface = -1;                                   ///< id of the surface's layer
    std::vector<SurfacePoint> picks;                    ///< faces are those of that layer
    std::vector<Vec3> positions;                        ///< of the picks, in world coordinates
    std::vector<int> corners;                           ///< picks that are corners
    std::vector<std::pair<int, PickTangent>> tangents;  ///< of picks, in world coordinates
    bool closed = false;
    std::optional<DrawnOptions> options;  ///< none: more was asked for than these can say
    /// In world coordinates, with faces of the arrays of that layer. Null: it is not known.
    std::shared_ptr<const Curve> curve;
    Matrix44m toWorld = Matrix44m::Identity();  ///< of that layer, when the curve was drawn
    std::string file;  ///< UTF-8; that the layer was read from with its picks; empty: none
};

/// Writes a source into its curve's layer.
void keepSource(MeshModel& curve, CurveSource source);

/// The same for a result.
void keepSource(
    MeshModel& curve,
    const MeshModel& surface,
    const LayerArrays& arrays,
    const CurveRequest& request,
    const CurveResult& result
);

/// The same for a curve that no request would draw through its picks.
void keepSource(
    MeshModel& curve, const MeshModel& surface, const LayerArrays& arrays, const Curve& made
);

/// The picks of a curve, as points of its surface.
[[nodiscard]] std::vector<SurfacePoint> pickPointsOf(const Curve& curve);
/// The positions of these.
[[nodiscard]] std::vector<Vec3> pickPositions(const Curve& curve);

/// Null where the layer is no curve of ours, or was read from a file and restoreCurves() was not
/// called since.
[[nodiscard]] const CurveSource* sourceOf(const MeshModel& layer);

/// The colour of the layer's vertices; none where they have none.
[[nodiscard]] std::optional<CurveColour> colourOf(const MeshModel& layer);

/// Marks a layer as one that goes with a curve: its tube, its control polygon, …
void attachToCurve(MeshModel& layer, const MeshModel& curve);

/// Whether a layer goes with a curve, and is none itself.
[[nodiscard]] bool isOfCurve(const MeshModel& layer);

/// Ids of the layer of a curve and of those that go with it.
[[nodiscard]] std::vector<int> layersOfCurve(const MeshDocument& document, int curve);

/// Marks a layer of polylines as the result of a filter that uses curves: lines at a distance, a
/// pattern. Such lines are no input of these filters unless they are chosen.
void markAsResult(MeshModel& layer);

/// Whether a layer is such a result.
[[nodiscard]] bool isResult(const MeshModel& layer);

/// Shows or hides the layer of a curve, and those that go with it.
void setCurveVisible(MeshDocument& document, int curve, bool isVisible);

/// Removes the layer of a curve, and those that go with it. Nothing where it is gone already.
void removeCurve(MeshDocument& document, int curve);

/// The id of the newest curve on this surface that was drawn through at least half of these picks
/// (world coordinates, to the bit); -1 where there is none.
[[nodiscard]] int curveOfPicks(
    const MeshDocument& document, int surface, std::span<const Vec3> picks
);

}  // namespace bspline_curve
