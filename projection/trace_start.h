// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/extended_surface.h"
#include "shell/shell.h"

namespace bspline_curve {

/// A shell to trace a curve through, and the point of the surface near which the curve starts.
/// Refers to what it is made from.
struct TraceStart {
    const Shell& shell;
    const ExtendedSurface& extended;
    SurfacePoint start;
    Vec3 startPosition;
};

}  // namespace bspline_curve
