// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/pick_candidates.h"
#include "filters/requests.h"
#include "host_document.h"

namespace bspline_curve {

/// Name of the per-mesh attribute of a curve's layer that holds the id of its surface's layer
/// (int).
inline constexpr const char* kSurfaceLayerAttribute = "bspline_curve_surface_layer";

/// Whether a layer has edges and no faces.
[[nodiscard]] bool isPolyline(const MeshModel& layer);

/// The layer that a curve, or what goes with it, was drawn on; null where the layer is none of ours
/// or its surface is gone.
[[nodiscard]] const MeshModel* surfaceOfCurve(const MeshDocument& document, const MeshModel& layer);

/// The layer that a curve is drawn on if the user names none: the current one. Where that has no
/// faces, or goes with a curve as its tube does: the layer that it was drawn on, else the only
/// layer with faces that goes with no curve. Null in a document without a current layer.
[[nodiscard]] const MeshModel* defaultSurface(const MeshDocument& document);

/// The layer that stands for the curves to use if the user names none: the surface itself, for its
/// curves. In a window the current layer if that is a curve, since it was clicked in the list
/// there; scripts have it as current after they drew it.
[[nodiscard]] const MeshModel* defaultCurves(const MeshDocument& document);

/// The layer that a parameter names. Throws InputError where there is none.
[[nodiscard]] const MeshModel& layerNamed(
    const MeshDocument& document, const LayerId& layer, const char* parameter
);

/// The layer that the request names. Throws InputError where there is none.
[[nodiscard]] const MeshModel& surfaceOf(const MeshDocument& document, const CurveRequest& request);

/// What the request may take its picks from. Throws InputError where it names a layer that is not
/// there.
[[nodiscard]] PickCandidates pickCandidates(
    const MeshDocument& document, const MeshModel& surface, const CurveRequest& request
);

}  // namespace bspline_curve
