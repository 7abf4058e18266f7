// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "imprint/mesh_parts.h"

#include <optional>
#include <vector>

namespace bspline_curve {

/// Which parts of an imprinted mesh are meant. All but Seed look only at parts that a curve parts
/// from another part, and leave components alone that no curve divides.
struct PartChoice {
    enum class Which {
        Largest,
        Smallest,
        Inside,  ///< all but the largest
        Seed,    ///< the one at a point
    };

    Which which = Which::Largest;
    Vec3 seed = Vec3::Zero();  ///< near the surface
};

/// Parts (labels, ascending) that have a curve between them and another part. O(n log n).
[[nodiscard]] std::vector<int> partedParts(const ImprintedMesh& imprinted, const MeshParts& parts);

/// Throws InputError (NoPath): there are no such parts.
[[noreturn]] void refuseNothingParted();

/// The parts meant (labels, ascending). Throws InputError (NoPath) where the curves part nothing,
/// and for a seed that is not finite (NonFiniteCoordinate), that is farther from the surface than a
/// pick may be (PickTooFar) or that lies between two parts (NoPath). O(n log n).
[[nodiscard]] std::vector<int> chosenParts(
    const ImprintedMesh& imprinted, const MeshParts& parts, const PartChoice& choice
);

/// The parts of each mesh that a cut makes (labels, ascending): the chosen ones, or where none is
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
