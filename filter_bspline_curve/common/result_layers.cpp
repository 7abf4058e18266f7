// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_bspline_curve/common/result_layers.h"

#include "filter_bspline_curve/common/curve_source.h"
#include "filter_bspline_curve/common/layer_making.h"
#include "filter_bspline_curve/common/polyline_layer.h"

#include <vcg/complex/algorithms/update/normal.h>

#include <cstddef>
#include <vector>

namespace bspline_curve {

namespace {

using Allocator = vcg::tri::Allocator<CMeshO>;

const vcg::Color4b kPolygonColour(40, 90, 200, 255);
const vcg::Color4b kTopColour(200, 80, 60, 255);
const vcg::Color4b kBottomColour(66, 110, 180, 255);

/// A layer beside the surface, not the current one.
MeshModel& addLayer(
    MeshDocument& document,
    const MeshModel& surface,
    const char* suffix,
    const std::vector<Vec3>& points,
    const vcg::Color4b& colour
) {
    MeshModel& layer = *document.addNewMesh("", nameOf(surface) + suffix, false);
    layer.updateDataMask(MeshModel::MM_VERTCOLOR);
    const FromWorld fromWorld(surface.cm.Tr);
    Allocator::AddVertices(layer.cm, points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        layer.cm.vert[i].P() = fromWorld(points[i]);
        layer.cm.vert[i].C() = colour;
    }
    return layer;
}

MeshModel& addMeshLayer(
    MeshDocument& document,
    const MeshModel& surface,
    const char* suffix,
    const TriangleMesh& mesh,
    const vcg::Color4b& colour
) {
    MeshModel& layer = addLayer(document, surface, suffix, mesh.vertices, colour);
    for (const Triangle& face : mesh.faces) {
        const auto corner = [&](std::size_t k) { return static_cast<std::size_t>(face[k]); };
        Allocator::AddFace(layer.cm, corner(0), corner(1), corner(2));
    }
    vcg::tri::UpdateNormal<CMeshO>::PerVertexNormalizedPerFaceNormalized(layer.cm);
    attachTo(surface, layer);
    return layer;
}

MeshModel& addPolygonLayer(
    MeshDocument& document, const MeshModel& surface, const ControlPolygon& polygon
) {
    MeshModel& layer =
        addLayer(document, surface, " control polygon", polygon.points, kPolygonColour);
    addEdges(layer.cm, polygon.closed);
    attachTo(surface, layer);
    return layer;
}

}  // namespace

void addResultLayers(
    MeshDocument& document,
    const MeshModel& surface,
    const LayerArrays& arrays,
    const CurveRequest& request,
    const CurveResult& result
) {
    MeshModel& curve = addPolylineLayer(
        document,
        {surface, arrays},
        result.curve.polyline,
        {.name = nameOf(surface) + " curve", .quality = result.quality, .isCurrent = true}
    );
    keepSource(curve, surface, arrays, request, result);
    const auto addMesh =
        [&](const char* suffix, const TriangleMesh& mesh, const vcg::Color4b& colour) {
            attachToCurve(addMeshLayer(document, surface, suffix, mesh, colour), curve);
        };
    if (result.tube) {
        addMesh(" tube", *result.tube, kCurveColour);
    }
    if (result.controlPolygon) {
        attachToCurve(addPolygonLayer(document, surface, *result.controlPolygon), curve);
    }
    if (result.shellLayers) {
        addMesh(" shell top", result.shellLayers->top, kTopColour);
        addMesh(" shell bottom", result.shellLayers->bottom, kBottomColour);
    }
}

void setQuality(MeshModel& layer, const LayerArrays& arrays, const FieldResult& result) {
    layer.updateDataMask(MeshModel::MM_VERTQUALITY);
    for (std::size_t i = 0; i < result.values.size(); ++i) {
        layer.cm.vert[arrays.vertexIds[i]].Q() =
            static_cast<CVertexO::QualityType>(result.values[i]);
    }
}

}  // namespace bspline_curve
