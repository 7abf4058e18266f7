// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_bspline_curve/common/result_layers.h"

#include "filter_bspline_curve/common/curve_source.h"
#include "filter_bspline_curve/common/surface_choice.h"

#include <Eigen/LU>

#include <vcg/complex/algorithms/update/normal.h>

#include <cstddef>
#include <vector>

namespace bspline_curve {

namespace {

using Allocator = vcg::tri::Allocator<CMeshO>;

const vcg::Color4b kCurveColour(225, 60, 30, 255);
const vcg::Color4b kPolygonColour(40, 90, 200, 255);
const vcg::Color4b kTopColour(200, 80, 60, 255);
const vcg::Color4b kBottomColour(66, 110, 180, 255);

/// The layer's label without the extension of its file.
QString nameOf(const MeshModel& layer) {
    const QString extension = "." + layer.suffixName();
    const QString label = layer.label();
    return extension.size() > 1 && label.endsWith(extension)
               ? label.left(label.size() - extension.size())
               : label;
}

void addEdges(CMeshO& mesh, bool closed) {
    const std::size_t count = mesh.vert.size();
    for (std::size_t i = 0; i + 1 < count; ++i) {
        Allocator::AddEdge(mesh, i, i + 1);
    }
    if (closed) {
        Allocator::AddEdge(mesh, count - 1, 0);
    }
}

/// Positions in the coordinates of the surface's layer, from the layer's own vertices.
void addVertices(
    CMeshO& curve,
    const MeshModel& surface,
    const LayerArrays& arrays,
    const SurfacePolyline& polyline
) {
    Allocator::AddVertices(curve, polyline.surfacePoints.size());
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
    auto faceIndex = Allocator::AddPerVertexAttribute<Scalarm>(curve, "face_index");
    auto barycentric = Allocator::AddPerVertexAttribute<Point3m>(curve, "barycentric");
    auto parameter = Allocator::AddPerVertexAttribute<Scalarm>(curve, "t");
    for (std::size_t i = 0; i < polyline.surfacePoints.size(); ++i) {
        const SurfacePoint& point = polyline.surfacePoints[i];
        const int face = arrays.faceIds[point.face];
        faceIndex[i] = static_cast<Scalarm>(face);
        barycentric[i] = toPoint3m(point.barycentric);
        parameter[i] = static_cast<Scalarm>(polyline.parameters[i]);
    }
}

/// Remembers the surface, and moves with it.
void attachTo(const MeshModel& surface, MeshModel& layer) {
    Allocator::AddPerMeshAttribute<int>(layer.cm, kSurfaceLayerAttribute)() = surface.id();
    layer.cm.Tr = surface.cm.Tr;
    vcg::tri::UpdateBounding<CMeshO>::Box(layer.cm);
}

MeshModel& addCurveLayer(
    MeshDocument& document,
    const MeshModel& surface,
    const LayerArrays& arrays,
    const CurveResult& result
) {
    const SurfacePolyline& polyline = result.curve.polyline;
    MeshModel& layer = *document.addNewMesh("", nameOf(surface) + " curve", true);
    layer.updateDataMask(MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTCOLOR);
    addVertices(layer.cm, surface, arrays, polyline);
    addEdges(layer.cm, polyline.closed);
    for (std::size_t i = 0; i < result.quality.size(); ++i) {
        layer.cm.vert[i].Q() = static_cast<CVertexO::QualityType>(result.quality[i]);
    }
    setAttributes(layer.cm, arrays, polyline);
    attachTo(surface, layer);
    return layer;
}

/// World coordinates as those of a layer; exactly the same where its matrix is the identity.
class FromWorld {
public:
    explicit FromWorld(const Matrix44m& matrix) : isIdentity_(matrix == Matrix44m::Identity()) {
        Eigen::Matrix4d toWorld;
        for (int row = 0; row < 4; ++row) {
            for (int column = 0; column < 4; ++column) {
                toWorld(row, column) = static_cast<double>(matrix.ElementAt(row, column));
            }
        }
        inverse_ = toWorld.inverse();
    }

    [[nodiscard]] Point3m operator()(const Vec3& world) const {
        return toPoint3m(
            isIdentity_ ? world : Vec3((inverse_ * world.homogeneous()).hnormalized())
        );
    }

private:
    bool isIdentity_;
    Eigen::Matrix4d inverse_;
};

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
    MeshModel& curve = addCurveLayer(document, surface, arrays, result);
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
