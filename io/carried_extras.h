// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/files.h"
#include "bspline_curve/parts.h"

namespace bspline_curve {

/// The extras of a mesh that was made of another, whose faces are `parents`: numbers of vertices
/// and corners are linear in the face that they are in, those of types of whole numbers but colours
/// as at the nearest corner; normals have the length 1. A vertex that fills a hole has the mean of
/// its rim, a face that does 0, and the heading of none. O(n).
[[nodiscard]] MeshExtras carriedExtras(
    const MeshExtras& extras, const MadeMesh& made, const std::vector<Triangle>& parents
);

}  // namespace bspline_curve
