// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/files.h"
#include "filters/pick_candidates.h"
#include "filters/requests.h"

namespace bspline_curve {

/// The picks of a request, in order, in world coordinates: from its text, its file or its layer, or
/// from the host's own tool where none of them is given; `closed` only where a file says so.
/// A layer with faces that the host offers by default counts only where there is nothing else.
/// Throws InputError where more than one is given, or none, where the layer has faces, or where the
/// text or the file cannot be read.
[[nodiscard]] PicksFile choosePicks(const CurveRequest& request, PickCandidates candidates);

}  // namespace bspline_curve
