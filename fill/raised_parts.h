// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fill/part_filling.h"

#include <vector>

namespace bspline_curve {

/// A whole imprinted mesh, of which some parts were moved along their normals. Walls between them
/// and the rest are its last faces; they have no face of the imprinted mesh and no label.
struct RaisedParts {
    FilledParts whole;
    /// Faces that were turned over: the surface bends more sharply there than the height allows.
    /// Not counted where there are shares.
    int turnedFaces = 0;
};

/// Moves the parts `chosen` (labels, ascending) by `height` along the normals at their vertices
/// (outwards where it is positive: relief; inwards: engraving), and joins them to the rest by walls
/// along curves. Normals are those at the vertices of the mesh without its imprint, weighted by
/// angles, and linear in its faces. Watertight and manifold where the mesh is, also where parts
/// meet in a vertex. `whole.crossing` has the faces that were moved or are walls and cross others,
/// exactly, as where `height` is more than the parts are wide. `height`: finite, in the user's
/// unit; 0 gives the imprinted mesh. `shares`: of the height, for each vertex of the imprint, of
/// which those on rims do not count: they stay, and there are no walls; empty: all of it. Throws
/// InputError (BadOption). O(n log n).
[[nodiscard]] RaisedParts raisedParts(
    const ImprintedMesh& imprinted,
    const MeshParts& parts,
    const std::vector<int>& chosen,
    double height,
    const std::vector<double>& shares = {}
);

}  // namespace bspline_curve
