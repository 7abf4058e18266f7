// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/run_filters.h"
#include "filters/workpiece_cache.h"

#include <common/interfaces.h>

/// The filters for MeshLab 2020.09 and its meshlabserver: they convert between layers and the
/// library of the filters and hold no algorithm. Dialogs of this version fold
/// no parameters away, so filters with many offer the main ones there, and are listed once more
/// with all of them.
class FilterBsplineCurveLegacyPlugin : public QObject, public MeshFilterInterface {
    Q_OBJECT
    MESHLAB_PLUGIN_IID_EXPORTER(MESH_FILTER_INTERFACE_IID)
    Q_INTERFACES(MeshFilterInterface)

public:
    FilterBsplineCurveLegacyPlugin();

    [[nodiscard]] QString pluginName() const override;
    [[nodiscard]] QString filterName(FilterIDType filter) const override;
    QString filterScriptFunctionName(FilterIDType filter) override;
    [[nodiscard]] QString filterInfo(FilterIDType filter) const override;
    FilterClass getClass(QAction* action) override;
    FILTER_ARITY filterArity(QAction* action) const override;
    int postCondition(QAction* action) const override;
    void initParameterSet(
        QAction* action, MeshDocument& document, RichParameterList& parameters
    ) override;

    /// False where the filter failed; the reason is then in errorMsg() and in the log, since
    /// meshlabserver prints only the log. Throws nothing: an exception ends the host.
    bool applyFilter(
        QAction* action,
        MeshDocument& document,
        const RichParameterList& parameters,
        vcg::CallBackPos* callback
    ) override;

private:
    void writeLog(const bspline_curve::LogLines& written);

    bspline_curve::WorkpieceCache workpieces_;
};
