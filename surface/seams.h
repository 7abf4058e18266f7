// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"
#include "surface/half_edges.h"

#include <vector>

namespace bspline_curve {

/// Two boundary edges that lie on each other: the surface goes on there, but its faces have
/// vertices of their own on either side, as along seams of texture coordinates.
struct Seam {
    HalfEdge a, b;
    bool isParallel;  ///< they lead the same way, so that one of the faces is turned over
};

/// The seams of a mesh, by their lowest vertices: pairs of edges of one face each whose ends have
/// the same coordinates. Where more than two such edges lie at one place, or two faces that lie on
/// each other as well, there is no seam. Takes any arrays; O(n), about 1 % of preparing a surface,
/// where no two vertices are at one place.
[[nodiscard]] std::vector<Seam> findSeams(const TriangleMesh& mesh);

}  // namespace bspline_curve
