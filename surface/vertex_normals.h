// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

#include <vector>

namespace bspline_curve {

/// Unit normals of the vertices, #V: means of the normals of their faces, weighted by the angles
/// that these have there, so that they do not depend on how flat parts are split into faces. Zero
/// where a vertex has no faces or their normals cancel. O(n).
[[nodiscard]] std::vector<Vec3> vertexNormals(const TriangleMesh& mesh);

/// Those means themselves, #V, not longer than 1: the shorter, the more the faces around bend.
[[nodiscard]] std::vector<Vec3> meanNormals(const TriangleMesh& mesh);

}  // namespace bspline_curve
