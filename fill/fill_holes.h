// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"
#include "bspline_curve/progress.h"

#include <array>
#include <cstdint>
#include <vector>

namespace bspline_curve {

enum class FillShape : std::uint8_t {
    Flat,    ///< no new vertices: a triangulation of the rim of least area
    Smooth,  ///< new vertices, as dense as those around, faired to go on in the tangent planes
};

/// The rims of a mesh: loops of boundary edges, each from its lowest vertex on, in the order in
/// which faces that fill it pass them. The mesh is one of Surface. O(n log n).
[[nodiscard]] std::vector<std::vector<int>> rimsOf(const std::vector<Triangle>& faces);

struct FilledMesh {
    TriangleMesh mesh;          ///< vertices and faces of the input first, as they were
    std::vector<int> firstNew;  ///< for each rim its first new vertex
};

/// Fills holes of a mesh, each given by its rim in the order of rimsOf(). Rims may meet in
/// vertices, which the caller then has to part where more than one fan of faces is left. Throws
/// InputError (NoPath) where a rim cannot be filled without new vertices, or where a new face would
/// have no area. New faces may pass through others. O(n^3) for rims of up to 400 vertices, O(n)
/// beyond.
[[nodiscard]] FilledMesh fillHoles(
    const TriangleMesh& mesh,
    const std::vector<std::vector<int>>& rims,
    FillShape shape,
    const Progress& progress = {}
);

}  // namespace bspline_curve
