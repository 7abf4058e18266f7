// SPDX-License-Identifier: GPL-3.0-or-later
#include "leave_picked_points.h"

#include <meshlabplugins/edit_pickpoints/pickedPoints.h>

#include <QStringList>

LeavePickedPointsPlugin::LeavePickedPointsPlugin() {
    typeList = {0};
    actionList.push_back(new QAction(filterName(0), this));
}

QString LeavePickedPointsPlugin::pluginName() const {
    return "LeavePickedPoints";
}

QString LeavePickedPointsPlugin::filterName(ActionIDType /*filter*/) const {
    return "Leave Picked Points";
}

QString LeavePickedPointsPlugin::pythonFilterName(ActionIDType /*filter*/) const {
    return "leave_picked_points";
}

QString LeavePickedPointsPlugin::filterInfo(ActionIDType /*filter*/) const {
    return "Leaves points on the current layer as the PickPoints tool does.";
}

FilterPlugin::FilterClass LeavePickedPointsPlugin::getClass(const QAction* /*action*/) const {
    return FilterPlugin::Other;
}

FilterPlugin::FilterArity LeavePickedPointsPlugin::filterArity(const QAction* /*action*/) const {
    return FilterPlugin::SINGLE_MESH;
}

RichParameterList LeavePickedPointsPlugin::initParameterList(
    const QAction* /*action*/, const MeshModel& /*layer*/
) {
    RichParameterList list;
    list.addParam(RichString("points", "", "Points", "x y z present; ... with present 0 or 1"));
    return list;
}

std::map<std::string, QVariant> LeavePickedPointsPlugin::applyFilter(
    const QAction* /*action*/,
    const RichParameterList& parameters,
    MeshDocument& document,
    unsigned int& postConditionMask,
    vcg::CallBackPos* /*callback*/
) {
    postConditionMask = MeshModel::MM_NONE;
    auto* points = new PickedPoints;  // the layer keeps it to the end, as with the tool
    for (const QString& text : parameters.getString("points").split(';')) {
        const QStringList words = text.split(' ', Qt::SkipEmptyParts);
        const Point3m point(words.at(0).toDouble(), words.at(1).toDouble(), words.at(2).toDouble());
        points->addPoint(
            QString::number(points->getPickedPointVector().size()), point, words.at(3) == "1"
        );
    }
    auto handle = vcg::tri::Allocator<CMeshO>::GetPerMeshAttribute<PickedPoints*>(
        document.mm()->cm, PickedPoints::Key
    );
    handle() = points;
    return {};
}
