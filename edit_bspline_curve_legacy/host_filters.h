// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filter_bspline_curve/common/dialog_parameters.h"

#include <common/filterscript.h>
#include <common/ml_shared_data_context.h>

// What MeshLab's versions spell differently about running filters: here, 2020.09.
namespace bspline_curve::host {

/// Which parameters of a filter its scripts have.
[[nodiscard]] inline Offered offeredToScripts(const FilterDescription& filter) {
    return &filter == &curveFilter() ? Offered::Usual : Offered::All;
}

/// The filters that were applied, as scripts are saved from.
[[nodiscard]] inline FilterScript& historyOf(MeshDocument& document) {
    return *document.filterHistory;
}

}  // namespace bspline_curve::host
