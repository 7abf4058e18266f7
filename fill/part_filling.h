// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/parts.h"
#include "fill/fill_holes.h"
#include "imprint/part_choice.h"

#include <optional>
#include <span>
#include <vector>

namespace bspline_curve {

/// Takes the parts `chosen` (labels, ascending) and fills each hole whose rim is made of curves
/// between them and other parts. Curves between two chosen parts, or with one on both sides, stay
/// closed. Throws InputError (NoPath) where no hole is left to fill, and as fillHoles() does. New
/// faces cross others only where `crossing` has them.
[[nodiscard]] FilledParts fillAround(
    const ImprintedMesh& imprinted,
    const MeshParts& parts,
    const std::vector<int>& chosen,
    FillShape shape,
    const Progress& progress = {}
);

/// The same where holes may all stay open, since the boundary of the mesh is part of their rims.
[[nodiscard]] FilledParts filledWherePossible(
    const ImprintedMesh& imprinted,
    const MeshParts& parts,
    const std::vector<int>& chosen,
    FillShape shape,
    const Progress& progress = {}
);

/// Throws InputError (NoPath): there is no hole to fill.
[[noreturn]] void refuseNothingToFill();

/// The whole imprinted mesh, as it is.
[[nodiscard]] FilledParts wholeImprint(const ImprintedMesh& imprinted, const MeshParts& parts);

/// The parts `chosen` (labels, ascending) of a mesh that was cut along its curves. O(n).
[[nodiscard]] FilledParts openParts(
    const CutMesh& cut, const MeshParts& parts, const std::vector<int>& chosen
);

/// openParts() where nothing is to be filled, else fillAround().
[[nodiscard]] FilledParts takenParts(
    const ImprintedMesh& imprinted,
    const CutMesh& cut,
    const MeshParts& parts,
    const std::vector<int>& chosen,
    const std::optional<FillShape>& fill,
    const Progress& progress = {}
);

}  // namespace bspline_curve
