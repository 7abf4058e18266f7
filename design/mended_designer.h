// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/designer.h"
#include "surface/mending.h"

namespace bspline_curve {

/// A designer on a mesh that is mended where it must be, see makeMended(); else as CurveDesigner.
/// Where more than two faces met in an edge, each curve may pass from any of them to any other:
/// for picks that mending has put on different components others are joined, for their curve alone.
[[nodiscard]] Mended<CurveDesigner> makeMendedDesigner(
    TriangleMesh mesh,
    const MendingOptions& mending,
    const ShellOptions& shell = {},
    const Progress& progress = {},
    const ShellStore* store = nullptr
);

}  // namespace bspline_curve
