// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filter_bspline_curve/curve_parameters.h"
#include "io/picks_reader.h"

#include <common/ml_document/mesh_document.h>

namespace bspline_curve {

/// The picks of a request, in order, in world coordinates: from its text, its file or its layer, or
/// from the surface's PickPoints where none of them is given; `closed` only where a file says so.
/// Throws MLException where more than one is given, or none, and InputError where the text or the
/// file cannot be read.
[[nodiscard]] PicksFile picksFor(const CurveRequest& request, const MeshDocument& document);

}  // namespace bspline_curve
