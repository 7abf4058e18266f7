// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/surface.h"

namespace bspline_curve {

/// The surface with its relief smoothed: in each pass inner vertices move along their normals only,
/// towards the mean of their neighbours and back by a little more (G. Taubin 1995), so that bumps
/// of an edge's size go and larger forms stay. What is flat stays as it is. Vertices and faces keep
/// their numbers. O(passes n).
[[nodiscard]] TriangleMesh smoothedRelief(const Surface& surface, int passes);

}  // namespace bspline_curve
