// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fill/part_filling.h"

#include <vector>

namespace bspline_curve {

/// Stands the parts `chosen` (labels, ascending) on a base: their rims are extruded to a plane,
/// in which what is between them is closed. A watertight solid, oriented as such. New faces have
/// no new vertices but those of the rims in the plane; `crossing` names them where they cross each
/// other or the part, exactly, as where the part hangs over its rim. Throws InputError: BadOption
/// (a length below 0, a direction of no length, no number), NoPath (a rim that crosses or touches
/// itself seen along the direction; a part that reaches beyond the plane or turns its inner side
/// away from it; no direction given where the parts have no mean normal). Parts without a rim stay.
/// O(n log n).
[[nodiscard]] FilledParts based(
    const ImprintedMesh& imprinted,
    const MeshParts& parts,
    const std::vector<int>& chosen,
    const PartBase& base
);

}  // namespace bspline_curve
