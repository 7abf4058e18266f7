// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/drawing_session.h"
#include "bspline_curve/sketch.h"
#include "surface/triangle_tree.h"

#include <optional>

namespace bspline_curve {

/// Whether a point at or in front of the surface is seen along a ray: picks lie on it, chords a
/// little below. `seen`: where the ray meets the surface (firstHit).
[[nodiscard]] bool isInSight(
    const Pointer& pointer, const TriangleTree::Hit& seen, const Vec3& point
);

/// What of a sketch is under the pointer: the nearest pick, else the nearest curve (its settled
/// polyline); of the active curve first. Neither what the surface hides nor a hidden curve is hit.
/// `seen`: where the ray meets the surface (firstHit). Linear in the number of picks and vertices.
[[nodiscard]] SketchHit hitTest(
    const Sketch& sketch,
    const Pointer& pointer,
    const TriangleTree::Hit& seen,
    const HitRadii& radii = {}
);

}  // namespace bspline_curve
