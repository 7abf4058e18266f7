// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

#include <span>

namespace bspline_curve {

/// A tube around a polyline, to be seen: closed and oriented outwards, with `sides` (at least 3)
/// corners around and, around an open polyline, a lid at both ends. Rings do not turn about the
/// polyline more than they have to (parallel transport); around a closed one the turn that is left
/// is spread over its whole length, so that there is no seam. Rings come no nearer to each other
/// than a quarter of the radius, so that the tube of a polyline with many short segments has few
/// faces. Where the polyline bends more sharply than the radius allows, the tube passes through
/// itself.
/// `points`: at least 2 (closed: 3), consecutive ones apart; `radius` above 0. O(n).
[[nodiscard]] TriangleMesh makeTube(
    std::span<const Vec3> points, bool closed, double radius, int sides = 12
);

}  // namespace bspline_curve
