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
#include <vector>

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

/// A new attribute of a value for each vertex, in place of one of that name and any type.
template <class Value, class ValueOf>
void setAttribute(CMeshO& mesh, const std::string& name, const ValueOf& valueOf) {
    Allocator::DeletePerVertexAttribute(mesh, name);
    auto attribute = Allocator::AddPerVertexAttribute<Value>(mesh, name);
    for (std::size_t i = 0; i < mesh.vert.size(); ++i) {
        attribute[i] = valueOf(i);
    }
}

template <class NumberOf>
void setNumbers(CMeshO& mesh, const std::string& name, const NumberOf& numberOf) {
    setAttribute<Scalarm>(mesh, name, [&](std::size_t i) {
        return static_cast<Scalarm>(numberOf(i));
    });
}

void setPlaces(CMeshO& curve, const LayerArrays& arrays, const std::vector<SurfacePoint>& places) {
    setNumbers(curve, kFaceIndexAttribute, [&](std::size_t i) {
        return arrays.faceIds[places[i].face];
    });
    setAttribute<Point3m>(curve, kBarycentricAttribute, [&](std::size_t i) {
        return toPoint3m(places[i].barycentric);
    });
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

MeshModel& addCurvePointsLayer(
    MeshDocument& document,
    const SurfaceLayer& surface,
    const PointsResult& result,
    const QString& name
) {
    const std::vector<CurvePoint>& points = result.points;
    SurfacePolyline places;
    for (const CurvePoint& point : points) {
        places.surfacePoints.push_back(point.place);
    }
    MeshModel& layer = *document.addNewMesh("", name, true);
    layer.updateDataMask(MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTCOLOR);
    CMeshO& mesh = layer.cm;
    Allocator::AddVertices(mesh, points.size());
    placeVertices(mesh, surface.layer, surface.arrays, places);
    setPlaces(mesh, surface.arrays, places.surfacePoints);
    const FromWorld fromWorld(surface.layer.cm.Tr);
    const auto ownDirection = [&](std::size_t i, const Vec3& vector) {
        const Vec3& at = points[i].position;
        const Vec3 own = fromWorld.inDoubles(at + vector) - fromWorld.inDoubles(at);
        return toPoint3m(own.normalized());
    };
    for (std::size_t i = 0; i < points.size(); ++i) {
        mesh.vert[i].Q() = static_cast<CVertexO::QualityType>(points[i].distance);
        mesh.vert[i].N() = ownDirection(i, points[i].normal);
    }
    setNumbers(mesh, "curve", [&](std::size_t i) { return result.curveOf[i]; });
    const auto setDirections = [&](const char* attribute, Vec3 CurvePoint::* member) {
        setAttribute<Point3m>(mesh, attribute, [&](std::size_t i) {
            return ownDirection(i, points[i].*member);
        });
    };
    setDirections("tangent", &CurvePoint::tangent);
    setDirections("left", &CurvePoint::left);
    const auto setFigures = [&](const char* attribute, double CurvePoint::* member) {
        setNumbers(mesh, attribute, [&](std::size_t i) { return points[i].*member; });
    };
    setFigures("distance", &CurvePoint::distance);
    setFigures("curvature", &CurvePoint::curvature);
    setFigures("normal_curvature", &CurvePoint::normalCurvature);
    setFigures("geodesic_curvature", &CurvePoint::geodesicCurvature);
    attachTo(surface.layer, layer);
    return layer;
}

void putOnSurface(MeshModel& layer, const SurfaceLayer& surface, const SurfacePolyline& polyline) {
    placeVertices(layer.cm, surface.layer, surface.arrays, polyline);
    setPlaces(layer.cm, surface.arrays, polyline.surfacePoints);
    setNumbers(layer.cm, kParameterAttribute, [&](std::size_t i) {
        return polyline.parameters[i];
    });
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
