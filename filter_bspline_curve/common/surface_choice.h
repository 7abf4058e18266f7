// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/layer_input.h"
#include "filters/requests.h"
#include "host_document.h"

namespace bspline_curve {

/// Name of the per-mesh attribute of a curve's layer that holds the id of its surface's layer
/// (int).
inline constexpr const char* kSurfaceLayerAttribute = "bspline_curve_surface_layer";

/// The layer that a curve is drawn on if the user names none: the current one; where that has no
/// faces, the layer that it was drawn on if it is a curve, else the only layer with faces. Null in
/// a document without a current layer.
[[nodiscard]] const MeshModel* defaultSurface(const MeshDocument& document);

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
