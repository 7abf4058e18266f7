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
    int turnedFaces = 0;
};

/// Moves the parts `chosen` (labels, ascending) by `height` along the normals at their vertices
/// (outwards where it is positive: relief; inwards: engraving), and joins them to the rest by walls
/// along curves. Normals are those at the vertices of the mesh without its imprint, weighted by
/// angles, and linear in its faces. Watertight and manifold where the mesh is, also where parts
/// meet in a vertex; it may pass through itself where `height` is more than the parts are wide.
/// `height`: finite, in the user's unit; 0 gives the imprinted mesh. Throws InputError (BadOption).
/// O(n log n).
[[nodiscard]] RaisedParts raisedParts(
    const ImprintedMesh& imprinted,
    const MeshParts& parts,
    const std::vector<int>& chosen,
    double height
);

}  // namespace bspline_curve
