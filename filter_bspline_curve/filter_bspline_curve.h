// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/run_filters.h"
#include "filters/workpiece_cache.h"

#include <common/plugins/interfaces/filter_plugin.h>

/// The filters for MeshLab 2022.02 and later and for pymeshlab: they convert between layers and the
/// library of the filters and hold no algorithm.
class FilterBsplineCurvePlugin : public QObject, public FilterPlugin {
    Q_OBJECT
    MESHLAB_PLUGIN_IID_EXPORTER(FILTER_PLUGIN_IID)
    Q_INTERFACES(FilterPlugin)

public:
    FilterBsplineCurvePlugin();

    [[nodiscard]] QString pluginName() const override;
    [[nodiscard]] QString vendor() const override;
    [[nodiscard]] QString filterName(ActionIDType filter) const override;
    [[nodiscard]] QString pythonFilterName(ActionIDType filter) const override;
    [[nodiscard]] QString filterInfo(ActionIDType filter) const override;
    [[nodiscard]] FilterClass getClass(const QAction* action) const override;
    [[nodiscard]] FilterArity filterArity(const QAction* action) const override;
    [[nodiscard]] int postCondition(const QAction* action) const override;
    RichParameterList initParameterList(
        const QAction* action, const MeshDocument& document
    ) override;

    /// Throws only MLException: any other exception ends the host.
    std::map<std::string, QVariant> applyFilter(
        const QAction* action,
        const RichParameterList& parameters,
        MeshDocument& document,
        unsigned int& postConditionMask,
        vcg::CallBackPos* callback
    ) override;

private:
    void writeLog(const bspline_curve::LogLines& written);

    bspline_curve::WorkpieceCache workpieces_;
};
