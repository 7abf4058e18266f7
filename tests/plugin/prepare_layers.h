// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <common/plugins/interfaces/filter_plugin.h>

/// Leaves points on the current layer as the PickPoints tool does.
class LeavePickedPointsPlugin : public QObject, public FilterPlugin {
    Q_OBJECT
    MESHLAB_PLUGIN_IID_EXPORTER(FILTER_PLUGIN_IID)
    Q_INTERFACES(FilterPlugin)

public:
    LeavePickedPointsPlugin();

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
