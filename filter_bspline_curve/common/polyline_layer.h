// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/mesh_checksum.h"
#include "filter_bspline_curve/common/layer_arrays.h"
#include "filters/run_curve_uses.h"
#include "host_document.h"

#include <QString>
#include <optional>
#include <span>

namespace bspline_curve {

/// A layer and its arrays.
struct SurfaceLayer {
    const MeshModel& layer;
    const LayerArrays& arrays;
};

struct PolylineLook {
    QString name;
    std::span<const double> quality;  ///< per vertex
    bool isCurrent = false;           ///< it becomes the document's current layer
};

/// Adds a layer with a polyline on the surface: vertices in order with edges between them, in the
/// coordinates of the surface's layer and under its matrix. Per vertex: quality, the surface's
/// normal, colour, and the custom attributes face_index (in the surface's layer), barycentric, t.
/// The layer remembers the surface and its checksum.
MeshModel& addPolylineLayer(
    MeshDocument& document,
    const SurfaceLayer& surface,
    const SurfacePolyline& polyline,
    const PolylineLook& look
);

/// The same with several polylines, each with edges of its own; quality is their t. It becomes the
/// current layer.
MeshModel& addPolylinesLayer(
    MeshDocument& document,
    const SurfaceLayer& surface,
    std::span<const SurfacePolyline* const> polylines,
    const QString& name
);

/// Adds a layer with points along curves of the surface, without edges, in the coordinates of the
/// surface's layer and under its matrix. Per vertex: the distance along its curve as quality, the
/// normal of its frame, colour, and the custom attributes curve, distance, tangent, left,
/// curvature, normal_curvature, geodesic_curvature, face_index (in the surface's layer) and
/// barycentric. It becomes the current layer.
MeshModel& addCurvePointsLayer(
    MeshDocument& document,
    const SurfaceLayer& surface,
    const PointsResult& result,
    const QString& name
);

/// Puts the vertices of a layer, as many as those of a polyline and in its order, where that is on
/// the surface, with all that addPolylineLayer() gives them but quality and edges.
void putOnSurface(MeshModel& layer, const SurfaceLayer& surface, const SurfacePolyline& polyline);

/// Lets a layer remember a surface and its checksum, as these do. `checksum`: where it is known.
void rememberSurface(
    MeshModel& layer, const MeshModel& surface, const std::optional<MeshChecksum>& checksum = {}
);

/// The checksum of the surface that these keep; null where the layer is none of ours.
[[nodiscard]] const MeshChecksum* checksumOfSurface(const MeshModel& polyline);

}  // namespace bspline_curve
