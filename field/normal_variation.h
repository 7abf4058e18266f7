// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/surface.h"

#include <vector>

namespace bspline_curve {

/// (24) for each vertex, #V: the least dot product of its normal and those of the faces around it,
/// in [-1, 1]: 1 where the surface is flat, less over creases and in noise. The paper's field,
/// which sees one ring only: on smooth parts it is nearer to 1 the finer the mesh. 1 at vertices
/// without faces. O(n), 0.1 us per vertex.
[[nodiscard]] std::vector<double> normalVariation(const Surface& surface);

}  // namespace bspline_curve
