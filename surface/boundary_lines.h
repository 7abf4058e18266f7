// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

#include <span>
#include <vector>

namespace bspline_curve {

/// A line of mesh edges between faces of two labels.
struct BoundaryLine {
    bool closed = false;
    std::vector<int> vertices;  ///< closed: the first one is not repeated
    int left = 0, right = 0;    ///< labels, seen along the line with the normals up
};

/// The lines between faces of different labels, each once: closed ones, and ones from junction to
/// junction, which are vertices where other than two such edges meet, or at the mesh's boundary;
/// edges of one face are no part of any. `labels`: one for each face. By their least vertex,
/// open ones first; O(#F log #F).
[[nodiscard]] std::vector<BoundaryLine> boundaryLines(
    const TriangleMesh& mesh, std::span<const int> labels
);

}  // namespace bspline_curve
