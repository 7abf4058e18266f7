// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filter_bspline_curve/common/dialog_parameters.h"

#include <common/filterscript.h>
#include <common/ml_shared_data_context/ml_shared_data_context.h>
#include <common/plugins/interfaces/filter_plugin.h>

#include <string>

// What MeshLab's versions spell differently about running filters: here, 2025.07.
namespace bspline_curve::host {

/// Which parameters of a filter its scripts have.
[[nodiscard]] inline Offered offeredToScripts(const FilterDescription& /*filter*/) {
    return Offered::All;
}

[[nodiscard]] inline bool isFilter(const QAction& action) {
    return qobject_cast<FilterPlugin*>(action.parent()) != nullptr;
}

/// Throws what tells why the filter failed.
inline void runFilter(
    QAction& filter, MeshDocument& document, const RichParameterList& parameters
) {
    auto& plugin = *qobject_cast<FilterPlugin*>(filter.parent());
    plugin.setLog(&document.Log);
    unsigned int changed = 0;
    plugin.applyFilter(&filter, parameters, document, changed, nullptr);
}

/// The filters that were applied, as scripts are saved from.
[[nodiscard]] inline FilterScript& historyOf(MeshDocument& document) {
    return document.filterHistory;
}

}  // namespace bspline_curve::host
