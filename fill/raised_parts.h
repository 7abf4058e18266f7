// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/progress.h"
#include "fill/part_filling.h"

#include <vector>

namespace bspline_curve {

/// A whole imprinted mesh, of which some parts were moved along their normals. Walls between them
/// and the rest are its last faces; they have no face of the imprinted mesh and no label.
struct RaisedParts {
    FilledParts whole;
    int lower = 0;       ///< vertices that were moved less than was asked for
    double least = 1.0;  ///< the least of that, relative
};

/// Moves the parts `chosen` (labels, ascending) by `height` along the normals at their vertices,
/// so that faces come to lie at this height (outwards where it is positive: relief; inwards:
/// engraving), and joins them to the rest by walls along curves. Normals are those at the vertices
/// of the mesh without its imprint, weighted by angles, and linear in its faces. Watertight and
/// manifold where the mesh is, also where parts meet in a vertex. Moved faces and walls cross
/// nothing, exactly: where they would, the relief is lower, see SettledWays; `whole.crossing` has
/// those that cross in spite of that, as where the mesh does. `height`: finite, in the user's unit;
/// 0 gives the imprinted mesh. `shares`: of the height, for each vertex of the imprint, of which
/// those on rims do not count: they stay, and there are no walls; empty: all of it. Throws
/// InputError (BadOption), Cancelled. O(n log n) a round.
[[nodiscard]] RaisedParts raisedParts(
    const ImprintedMesh& imprinted,
    const MeshParts& parts,
    const std::vector<int>& chosen,
    double height,
    const std::vector<double>& shares = {},
    const Progress& progress = {}
);

}  // namespace bspline_curve
