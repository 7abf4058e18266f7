// SPDX-License-Identifier: GPL-3.0-or-later
#include "prepare_layers.h"

#include "filter_bspline_curve/common/layer_arrays.h"

#include <meshlabplugins/edit_pickpoints/pickedPoints.h>
#include <vcg/complex/algorithms/clean.h>

#include <QStringList>
#include <array>

namespace {

using Allocator = vcg::tri::Allocator<CMeshO>;

void leavePickedPoints(CMeshO& mesh, const QString& text) {
    auto* points = new PickedPoints;  // the layer keeps it to the end, as with the tool
    for (const QString& part : text.split(';')) {
        const QStringList words = part.split(' ', Qt::SkipEmptyParts);
        const Point3m point(words.at(0).toDouble(), words.at(1).toDouble(), words.at(2).toDouble());
        const QString name = QString::number(points->getPickedPointVector().size());
        points->addPoint(name, point, words.at(3) == "1");
    }
    Allocator::GetPerMeshAttribute<PickedPoints*>(mesh, PickedPoints::Key)() = points;
}

template <typename Rows>
QVariant flattened(const Rows& rows) {
    std::vector<double> values;
    for (const auto& row : rows) {
        values.insert(values.end(), row.begin(), row.end());
    }
    return QVariant::fromValue<Eigen::VectorXd>(
        Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()))
    );
}

std::map<std::string, QVariant> convertWithDeleted(MeshModel& layer, int faces) {
    for (int f = 0; f < faces; ++f) {
        Allocator::DeleteFace(layer.cm, layer.cm.face[f]);
    }
    vcg::tri::Clean<CMeshO>::RemoveUnreferencedVertex(layer.cm);
    const bspline_curve::LayerArrays mesh = bspline_curve::arraysOf(layer);
    return {
        {"has_layers_ids", mesh.input.hasLayersIds},
        {"vertices", flattened(mesh.input.mesh.vertices)},
        {"faces", flattened(mesh.input.mesh.faces)},
        {"vertex_ids", flattened(std::array{mesh.vertexIds})},
        {"face_ids", flattened(std::array{mesh.faceIds})},
    };
}

}  // namespace

PrepareLayersPlugin::PrepareLayersPlugin() {
    typeList = {LeavePickedPoints, ConvertWithDeleted};
    for (const ActionIDType type : types()) {
        actionList.push_back(new QAction(filterName(type), this));
    }
}

QString PrepareLayersPlugin::pluginName() const {
    return "PrepareLayers";
}

QString PrepareLayersPlugin::filterName(ActionIDType filter) const {
    return filter == LeavePickedPoints ? "Leave Picked Points" : "Convert with Deleted";
}

QString PrepareLayersPlugin::pythonFilterName(ActionIDType filter) const {
    return filter == LeavePickedPoints ? "leave_picked_points" : "convert_with_deleted";
}

QString PrepareLayersPlugin::filterInfo(ActionIDType filter) const {
    return filterName(filter);
}

FilterPlugin::FilterClass PrepareLayersPlugin::getClass(const QAction* /*action*/) const {
    return FilterPlugin::Other;
}

FilterPlugin::FilterArity PrepareLayersPlugin::filterArity(const QAction* /*action*/) const {
    return FilterPlugin::SINGLE_MESH;
}

RichParameterList PrepareLayersPlugin::initParameterList(
    const QAction* action, const MeshModel& /*layer*/
) {
    RichParameterList list;
    if (ID(action) == LeavePickedPoints) {
        list.addParam(RichString("points", "", "Points", "x y z present; ... with present 0 or 1"));
    } else {
        list.addParam(RichInt("faces", 0, "Faces", "How many of the first faces to delete"));
    }
    return list;
}

std::map<std::string, QVariant> PrepareLayersPlugin::applyFilter(
    const QAction* action,
    const RichParameterList& parameters,
    MeshDocument& document,
    unsigned int& postConditionMask,
    vcg::CallBackPos* /*callback*/
) {
    postConditionMask = MeshModel::MM_NONE;
    if (ID(action) == LeavePickedPoints) {
        leavePickedPoints(document.mm()->cm, parameters.getString("points"));
        return {};
    }
    return convertWithDeleted(*document.mm(), parameters.getInt("faces"));
}
