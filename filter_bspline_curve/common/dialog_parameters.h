// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/filter_description.h"
#include "filters/parameter_values.h"
#include "host_parameters.h"

namespace bspline_curve {

/// Which parameters of a filter a host is told of.
enum class Offered {
    All,
    Usual,  ///< without the advanced ones and those of a window, for scripts that must list each
    Main,   ///< those that stand above the fold, for dialogs that have none
};

/// The parameters of a filter as the host's dialogs, scripts and Python calls take them, with the
/// defaults for this document. In a window a curve comes with a thin tube, since the window draws
/// polylines one pixel wide, and replaces the one whose picks were moved; a cut makes a layer of
/// each part; a curve that is the current layer is the one to use.
[[nodiscard]] RichParameterList dialogParameters(
    const FilterDescription& filter, host::DialogDocument& document, Offered offered = Offered::All
);

/// Sets a parameter of such a list, other than a file. Throws std::out_of_range or
/// std::bad_variant_access where the filter has no such parameter or option: a bug of the caller.
void setParameter(
    RichParameterList& list,
    const ParameterDescription& parameter,
    const ParameterValue& value,
    MeshDocument& document
);

/// What the user gave; a parameter that was not offered has its default. Throws InputError where an
/// enumeration has no such option.
[[nodiscard]] ParameterValues valuesOf(
    const RichParameterList& list, const FilterDescription& filter
);

}  // namespace bspline_curve
