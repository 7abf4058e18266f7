// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/parts.h"
#include "imprint/mesh_parts.h"

#include <optional>
#include <vector>

namespace bspline_curve {

/// Parts (labels, ascending) that have a curve between them and another part. O(n log n).
[[nodiscard]] std::vector<int> partedParts(const ImprintedMesh& imprinted, const MeshParts& parts);

/// Throws InputError (NoPath): there are no such parts.
[[noreturn]] void refuseNothingParted();

/// The parts meant (labels, ascending). Throws InputError (NoPath) where the curves part nothing,
/// or none is meant, and for a seed that is not finite (NonFiniteCoordinate), that is farther from
/// the surface than a pick may be (PickTooFar) or that lies between two parts (NoPath). O(n log n).
[[nodiscard]] std::vector<int> chosenParts(
    const ImprintedMesh& imprinted, const MeshParts& parts, const PartChoice& choice
);

/// Those and the components that no curve parts, unless these are dropped.
[[nodiscard]] std::vector<int> keptParts(
    const ImprintedMesh& imprinted, const MeshParts& parts, const PartChoice& choice
);

/// The parts of each mesh that a cut makes (labels, ascending): the kept ones, or where none is
/// chosen all in one, or with `split` each part at a curve by itself and those together that no
/// curve parts from another; the mesh with the largest part first. Throws like chosenParts().
[[nodiscard]] std::vector<std::vector<int>> partsPerMesh(
    const ImprintedMesh& imprinted,
    const MeshParts& parts,
    const std::optional<PartChoice>& choice,
    bool split
);

/// cutAlongCurves() where that opens something. Throws InputError (NoPath) where it does not.
[[nodiscard]] CutMesh openedAlongCurves(const ImprintedMesh& imprinted);

/// Edges of curves between chosen parts and others, each (lower, higher vertex), ascending.
[[nodiscard]] std::vector<std::array<int, 2>> edgesAround(
    const ImprintedMesh& imprinted, const MeshParts& parts, const std::vector<int>& chosen
);

}  // namespace bspline_curve
