// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/run_filters.h"

#include <span>

// What a curve leaves besides its layer.
namespace bspline_curve {

/// Refuses a file that cannot be written, which else would only show after the work. Throws
/// InputError (UnwritableFile).
void checkSaveFile(const CurveRequest& request);

/// Refuses a tube that is larger than the mesh. Throws InputError (BadOption).
void checkTube(const CurveRequest& request, const Workpiece& workpiece);

/// Adds to a result what the request asks for, and writes its file. `along`: the field along the
/// curve, or empty. Throws InputError (UnwritableFile).
void addExtras(
    const CurveRequest& request,
    const Workpiece& workpiece,
    std::span<const double> along,
    CurveResult& result
);

}  // namespace bspline_curve
