// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"
#include "bspline_curve/parts.h"
#include "bspline_curve/progress.h"
#include "fill/sheet_patch.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace bspline_curve {

/// The rims of a mesh: loops of boundary edges, each from its lowest vertex on, in the order in
/// which faces that fill it pass them. The mesh is one of Surface. O(n log n).
[[nodiscard]] std::vector<std::vector<int>> rimsOf(const std::vector<Triangle>& faces);

/// What is known of a mesh beside it.
struct FillSurroundings {
    std::vector<double> sizes;  ///< for each vertex the length of edges around; empty: measured
    /// What was in a hole before, of which the number is given; where that is a disc of at most so
    /// many faces.
    std::function<std::optional<Patch>(std::size_t rim, std::size_t most)> removed;
};

struct FilledMesh {
    TriangleMesh mesh;           ///< vertices and faces of the input first, as they were
    std::vector<int> firstNew;   ///< for each rim its first new vertex
    std::vector<int> firstFace;  ///< likewise its first new face
    std::vector<int> crossing;   ///< new faces that cross others, where no way of filling has none
};

/// Fills holes of a mesh, each given by its rim in the order of rimsOf(). Rims may meet in
/// vertices, which the caller then has to part where more than one fan of faces is left.
/// New faces cross neither each other nor others, exactly, unless `crossing` has them: each patch
/// is checked, and one way tried after the other. Flat: a triangulation in a plane, one that bends
/// least, one that bends least of those that do not cross, then, with new vertices, what was in the
/// hole or is behind it, stretched over the rim as far as it crosses nothing. Smooth: a faired
/// patch, then a flat one that is divided and faired as far as it crosses nothing, then as flat.
/// Throws InputError (NoPath) where a rim cannot be filled, as one that is a face of the mesh.
/// O(n^3) for rims of up to 160 vertices, O(n) beyond; O(n log n) checks.
[[nodiscard]] FilledMesh fillHoles(
    const TriangleMesh& mesh,
    const std::vector<std::vector<int>>& rims,
    FillShape shape,
    const FillSurroundings& surroundings = {},
    const Progress& progress = {}
);

}  // namespace bspline_curve
