// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <common/plugins/interfaces/filter_plugin.h>

/// Filters for the tests only: they bring the current layer into states that only MeshLab's window
/// reaches.
///   leave_picked_points  leaves points on the layer as the PickPoints tool does
///   delete_in_place      marks the first faces as deleted, and unreferenced vertices, without
///   compacting the arrays
class PrepareLayersPlugin : public QObject, public FilterPlugin {
    Q_OBJECT
    MESHLAB_PLUGIN_IID_EXPORTER(FILTER_PLUGIN_IID)
    Q_INTERFACES(FilterPlugin)

public:
    enum Filter : ActionIDType { LeavePickedPoints, ConvertWithDeleted };

    PrepareLayersPlugin();

    [[nodiscard]] QString pluginName() const override;
    [[nodiscard]] QString filterName(ActionIDType filter) const override;
    [[nodiscard]] QString pythonFilterName(ActionIDType filter) const override;
    [[nodiscard]] QString filterInfo(ActionIDType filter) const override;
    [[nodiscard]] FilterClass getClass(const QAction* action) const override;
    [[nodiscard]] FilterArity filterArity(const QAction* action) const override;
    RichParameterList initParameterList(const QAction* action, const MeshModel& layer) override;
    std::map<std::string, QVariant> applyFilter(
        const QAction* action,
        const RichParameterList& parameters,
        MeshDocument& document,
        unsigned int& postConditionMask,
        vcg::CallBackPos* callback
    ) override;
};
