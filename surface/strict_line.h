// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "surface/surface.h"

#include <string>

namespace bspline_curve {

/// Whether every segment of a polyline on a surface lies in one face: by the faces (the surface's
/// own) and barycentric coordinates of its ends, not by positions, so that the sides of the
/// thinnest plate are two. O(n).
[[nodiscard]] bool isStrict(const Surface& surface, const SurfacePolyline& line);

/// A polyline of the surface's input on the surface itself. `name`: of the curve, for messages.
/// Throws InputError (NoPath) where it passes a face that mending has removed, or is not strict
/// there: it is of another mesh, or passes from sheet to sheet where mending parts them. O(n log
/// n).
[[nodiscard]] SurfacePolyline strictLine(
    const Surface& surface, SurfacePolyline line, const std::string& name
);

}  // namespace bspline_curve
