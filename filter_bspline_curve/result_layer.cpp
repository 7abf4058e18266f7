// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_bspline_curve/result_layer.h"

#include "filter_bspline_curve/curve_parameters.h"
#include "io/curve_writer.h"

// The metatypes of the host's results (vectors) are declared here.
#include <common/plugins/interfaces/filter_plugin.h>

namespace bspline_curve {

namespace {

const vcg::Color4b kCurveColour(225, 60, 30, 255);

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
        vcg::tri::Allocator<CMeshO>::AddEdge(mesh, i, i + 1);
    }
    if (closed) {
        vcg::tri::Allocator<CMeshO>::AddEdge(mesh, count - 1, 0);
    }
}

/// Positions in the coordinates of the surface's layer, from the layer's own vertices.
void addVertices(
    CMeshO& curve, const MeshModel& surface, const LayerMesh& mesh, const SurfacePolyline& polyline
) {
    vcg::tri::Allocator<CMeshO>::AddVertices(curve, polyline.surfacePoints.size());
    for (std::size_t i = 0; i < polyline.surfacePoints.size(); ++i) {
        const auto& [face, barycentric] = polyline.surfacePoints[i];
        const int layerFace = mesh.faceIds[static_cast<std::size_t>(face)];
        const CFaceO& corners = surface.cm.face[static_cast<std::size_t>(layerFace)];
        curve.vert[i].P() = corners.cP(0) * barycentric[0] + corners.cP(1) * barycentric[1] +
                            corners.cP(2) * barycentric[2];
        curve.vert[i].N() = vcg::TriangleNormal(corners).Normalize();
        curve.vert[i].C() = kCurveColour;
    }
}

void setQuality(
    CMeshO& curve,
    const LayerMesh& mesh,
    const SurfacePolyline& polyline,
    std::span<const double> field
) {
    const std::vector<double> quality =
        field.empty() ? polyline.parameters : fieldAlong(polyline, mesh.world.faces, field);
    for (std::size_t i = 0; i < quality.size(); ++i) {
        curve.vert[i].Q() = quality[i];
    }
}

void setAttributes(CMeshO& curve, const LayerMesh& mesh, const SurfacePolyline& polyline) {
    using Allocator = vcg::tri::Allocator<CMeshO>;
    auto faceIndex = Allocator::AddPerVertexAttribute<Scalarm>(curve, "face_index");
    auto barycentric = Allocator::AddPerVertexAttribute<Point3m>(curve, "barycentric");
    auto parameter = Allocator::AddPerVertexAttribute<Scalarm>(curve, "t");
    for (std::size_t i = 0; i < polyline.surfacePoints.size(); ++i) {
        const SurfacePoint& point = polyline.surfacePoints[i];
        faceIndex[i] = mesh.faceIds[static_cast<std::size_t>(point.face)];
        barycentric[i] = toPoint3m(point.barycentric);
        parameter[i] = polyline.parameters[i];
    }
}

double lengthOf(const SurfacePolyline& polyline) {
    double length = 0.0;
    for (std::size_t i = 1; i < polyline.points.size(); ++i) {
        length += (polyline.points[i] - polyline.points[i - 1]).norm();
    }
    return polyline.closed ? length + (polyline.points.front() - polyline.points.back()).norm()
                           : length;
}

/// Of one curve on a surface that is ready.
double secondsOf(const SolveReport& report) {
    const auto& [path, initial, minimise, knots, polyline] = report.seconds;
    return path + initial + minimise + knots + polyline;
}

QVariant vectorOf(const std::vector<double>& values) {
    return QVariant::fromValue<Eigen::VectorXd>(
        Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()))
    );
}

/// x, y, z of each point in turn: hosts keep vectors, but no matrix of n rows.
QVariant vectorOf(const std::vector<Vec3>& points) {
    std::vector<double> values;
    for (const Vec3& p : points) {
        values.insert(values.end(), {p.x(), p.y(), p.z()});
    }
    return vectorOf(values);
}

QVariant vectorOf(const std::vector<int>& indices) {
    return vectorOf(std::vector<double>(indices.begin(), indices.end()));
}

}  // namespace

MeshModel& addCurveLayer(
    MeshDocument& document,
    const MeshModel& surface,
    const LayerMesh& mesh,
    const Curve& curve,
    std::span<const double> field
) {
    MeshModel& layer = *document.addNewMesh("", nameOf(surface) + " curve", true);
    layer.updateDataMask(MeshModel::MM_VERTQUALITY | MeshModel::MM_VERTCOLOR);
    addVertices(layer.cm, surface, mesh, curve.polyline);
    addEdges(layer.cm, curve.polyline.closed);
    setQuality(layer.cm, mesh, curve.polyline, field);
    setAttributes(layer.cm, mesh, curve.polyline);
    vcg::tri::Allocator<CMeshO>::AddPerMeshAttribute<int>(layer.cm, kSurfaceLayerAttribute)() =
        surface.id();
    layer.cm.Tr = surface.cm.Tr;
    vcg::tri::UpdateBounding<CMeshO>::Box(layer.cm);
    return layer;
}

std::map<std::string, QVariant> figuresOf(
    const Curve& curve, const CurveDesigner& designer, double seconds
) {
    const SolveReport& report = curve.report;
    const StageSeconds& surfaceSeconds = designer.seconds();
    const ShellSummary& shell = designer.shell();
    return {
        {"shell_cached", shell.isFromStore},
        {"prisms", shell.prisms},
        {"usable", report.usable},
        {"converged", report.status == SolveStatus::Converged},
        {"closed", curve.polyline.closed},
        {"degree", curve.spline.degree},
        {"vertices", static_cast<int>(curve.polyline.points.size())},
        {"length", lengthOf(curve.polyline)},
        {"knots_first", report.knotsFirst},
        {"knots_last", report.knotsLast},
        {"max_distance", report.maxDistance},
        {"max_pick_gap", report.maxPickGap},
        {"rounds", static_cast<int>(report.rounds.size())},
        {"newton_iterations", report.newtonIterations},
        {"field_cost", report.fieldCost},
        {"field_at_rest", report.fieldAtRest},
        {"avoided_faces", report.avoidedFaces},
        {"clearance", report.clearance},
        {"seconds", seconds},
        {"seconds_surface", surfaceSeconds.validate + surfaceSeconds.tree},
        {"seconds_shell", surfaceSeconds.shell},
        {"seconds_curve", secondsOf(report)},
        {"knots", vectorOf(curve.spline.knots)},
        {"control_points", vectorOf(curve.spline.controlPoints)},
        {"pick_parameters", vectorOf(curve.spline.pickParameters)},
        {"pick_vertices", vectorOf(curve.polyline.picks)},
    };
}

std::string logLine(const std::map<std::string, QVariant>& figures, const ShellSummary& shell) {
    // No figure, since pymeshlab warns of texts.
    std::string line = std::string("shell=") + (shell.isFromStore ? "cached" : name(shell.kind));
    for (const auto& [key, value] : figures) {
        if (value.canConvert<QString>()) {
            line += " " + key + "=" + value.toString().toStdString();
        }
    }
    return line;
}

}  // namespace bspline_curve
