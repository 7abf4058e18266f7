// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/progress.h"
#include "fill/part_filling.h"

#include <vector>

namespace bspline_curve {

/// Parts that became walls: between them and their copies at a distance, closed along their rims.
struct ThickParts {
    FilledParts solid;
    int thinner = 0;     ///< vertices at which the wall is thinner than was asked for
    double least = 1.0;  ///< the least thickness, relative to that
};

/// Gives the parts `chosen` (labels, ascending) a thickness: outwards where it is positive, inwards
/// where it is negative. The copy is at this distance from the planes of the faces: vertices move
/// along the mean normals n of the mesh without its imprint by thickness / |n| (at most twice as
/// far), linear in its faces, so that edges of a box stay sharp. Watertight and oriented as a
/// solid. The other side may cross nothing, exactly: where it would, directions are smoothed
/// around, if that helps, then the wall is made thinner there, with a slope of at most a half.
/// `solid.crossing` has the faces that cross in spite of that, as where the part crosses itself.
/// Outwards, the faces of the imprint are on the moved side. Throws InputError (BadOption: not
/// finite, or 0), Cancelled. O(n log n) a round, of which there are at most 64.
[[nodiscard]] ThickParts thickened(
    const ImprintedMesh& imprinted,
    const MeshParts& parts,
    const std::vector<int>& chosen,
    double thickness,
    const Progress& progress = {}
);

}  // namespace bspline_curve
