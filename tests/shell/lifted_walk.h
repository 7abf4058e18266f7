// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/polynomial_trace.h"

namespace bspline_curve::test_support {

/// Walks from a point of the surface to height w of its fibre, as curves do: straight where that
/// stays inside, else along the fibre in shorter and shorter steps. Returns whether it arrives; the
/// state holds the end then.
[[nodiscard]] bool walkUp(
    const Shell& shell,
    const ExtendedSurface& extended,
    const SurfacePoint& point,
    double w,
    TraceState& state
);

}  // namespace bspline_curve::test_support
