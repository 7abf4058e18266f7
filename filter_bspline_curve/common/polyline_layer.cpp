// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_bspline_curve/common/polyline_layer.h"

#include "filter_bspline_curve/common/layer_making.h"
#include "filter_bspline_curve/common/polyline_attributes.h"
#include "filter_bspline_curve/common/save_watcher.h"
#include "filter_bspline_curve/common/surface_choice.h"
#include "filter_bspline_curve/common/window.h"

#include <vcg/complex/algorithms/update/normal.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>

namespace bspline_curve {

namespace {

using Allocator = vcg::tri::Allocator<CMeshO>;

const std::string kChecksum = "bspline_curve_surface_checksum";

/// Positions in the coordinates of the surface's layer, from the layer's own vertices.
void placeVertices(
    CMeshO& curve,
    const MeshModel& surface,
    const LayerArrays& arrays,
    const SurfacePolyline& polyline
) {
    for (std::size_t i = 0; i < polyline.surfacePoints.size(); ++i) {
        const auto& [face, barycentric] = polyline.surfacePoints[i];
        const int layerFace = arrays.faceIds[face];
        const CFaceO& corners = surface.cm.face[layerFace];
        const Vec3 position = toVec3(corners.cP(0)) * barycentric[0] +
                              toVec3(corners.cP(1)) * barycentric[1] +
                              toVec3(corners.cP(2)) * barycentric[2];
        curve.vert[i].P() = toPoint3m(position);
        curve.vert[i].N() = vcg::TriangleNormal(corners).Normalize();
        curve.vert[i].C() = kCurveColour;
    }
}

void setAttributes(CMeshO& curve, const LayerArrays& arrays, const SurfacePolyline& polyline) {
    for (const std::string& name :
         {kFaceIndexAttribute, kBarycentricAttribute, kParameterAttribute}) {
        Allocator::DeletePerVertexAttribute(curve, name);  // of any type, read from a file
    }
    auto faceIndex = Allocator::AddPerVertexAttribute<Scalarm>(curve, kFaceIndexAttribute);
    auto barycentric = Allocator::AddPerVertexAttribute<Point3m>(curve, kBarycentricAttribute);
    auto parameter = Allocator::AddPerVertexAttribute<Scalarm>(curve, kParameterAttribute);
    for (std::size_t i = 0; i < polyline.surfacePoints.size(); ++i) {
        const SurfacePoint& point = polyline.surfacePoints[i];
        const int face = arrays.faceIds[point.face];
        faceIndex[i] = static_cast<Scalarm>(face);
        barycentric[i] = toPoint3m(point.barycentric);
        parameter[i] = static_cast<Scalarm>(polyline.parameters[i]);
    }
}

}  // namespace

namespace {

/// A layer without edges.
MeshModel& addPointsLayer(
    MeshDocument& document,
    const SurfaceLayer& surface,
    const SurfacePolyline& polyline,
    const PolylineLook& look
) {
    MeshModel& layer = *document.addNewMesh("", look.name, look.isCurrent);
    layer.updateDataMask(MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTCOLOR);
    Allocator::AddVertices(layer.cm, polyline.surfacePoints.size());
    for (std::size_t i = 0; i < look.quality.size(); ++i) {
        layer.cm.vert[i].Q() = static_cast<CVertexO::QualityType>(look.quality[i]);
    }
    putOnSurface(layer, surface, polyline);
    if (hasWindow()) {
        watchSaving(document);
    }
    return layer;
}

}  // namespace

MeshModel& addPolylineLayer(
    MeshDocument& document,
    const SurfaceLayer& surface,
    const SurfacePolyline& polyline,
    const PolylineLook& look
) {
    MeshModel& layer = addPointsLayer(document, surface, polyline, look);
    addEdges(layer.cm, polyline.closed);
    return layer;
}

MeshModel& addPolylinesLayer(
    MeshDocument& document,
    const SurfaceLayer& surface,
    std::span<const SurfacePolyline* const> polylines,
    const QString& name
) {
    SurfacePolyline all;
    for (const SurfacePolyline* const line : polylines) {
        std::ranges::copy(line->surfacePoints, std::back_inserter(all.surfacePoints));
        std::ranges::copy(line->parameters, std::back_inserter(all.parameters));
    }
    MeshModel& layer = addPointsLayer(
        document, surface, all, {.name = name, .quality = all.parameters, .isCurrent = true}
    );
    std::size_t first = 0;
    for (const SurfacePolyline* const line : polylines) {
        const std::size_t end = first + line->surfacePoints.size();
        addEdges(layer.cm, first, end, line->closed);
        first = end;
    }
    return layer;
}

void putOnSurface(MeshModel& layer, const SurfaceLayer& surface, const SurfacePolyline& polyline) {
    placeVertices(layer.cm, surface.layer, surface.arrays, polyline);
    setAttributes(layer.cm, surface.arrays, polyline);
    attachTo(surface.layer, layer);
    rememberSurface(layer, surface.layer, surface.arrays.checksum);
}

void rememberSurface(
    MeshModel& layer, const MeshModel& surface, const std::optional<MeshChecksum>& checksum
) {
    Allocator::GetPerMeshAttribute<int>(layer.cm, kSurfaceLayerAttribute)() = surface.id();
    Allocator::GetPerMeshAttribute<MeshChecksum>(layer.cm, kChecksum)() =
        checksum ? *checksum : checksumOf(surface);
}

const MeshChecksum* checksumOfSurface(const MeshModel& polyline) {
    return host::perMeshAttribute<MeshChecksum>(polyline.cm, kChecksum);
}

}  // namespace bspline_curve
