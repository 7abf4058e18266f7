// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/filter_description.h"
#include "filters/parameter_values.h"
#include "host_parameters.h"

namespace bspline_curve {

/// The parameters of a filter as the host's dialogs, scripts and Python calls take them, with the
/// defaults for this document.
[[nodiscard]] RichParameterList dialogParameters(
    const FilterDescription& filter, host::DialogDocument& document
);

/// What the user gave. Throws InputError where an enumeration has no such option.
[[nodiscard]] ParameterValues valuesOf(
    const RichParameterList& list, const FilterDescription& filter
);

}  // namespace bspline_curve
