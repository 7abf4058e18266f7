// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fill/fill_holes.h"
#include "imprint/part_choice.h"

#include <optional>
#include <span>
#include <vector>

namespace bspline_curve {

/// Chosen parts of an imprinted mesh, opened along its curves, or with the holes filled that the
/// others leave.
struct FilledParts {
    TriangleMesh mesh;
    std::vector<int> source;  ///< for each vertex that of the imprinted mesh; -1: new
    std::vector<int> faces;   ///< for each face that of the imprinted mesh; -1: new
    std::vector<int> labels;  ///< for each face its part; -1: new
    /// For the last faces, walls of a relief: the face of the imprinted mesh, at the wall's foot or
    /// top, that each corner is on.
    std::vector<Triangle> walls;
    std::vector<std::vector<int>> rims;  ///< of the filled holes, vertices of `mesh`
    std::vector<int> firstNew;           ///< for each of these its first new vertex
    std::vector<int> firstFace;          ///< likewise its first new face; they are the last faces
    int endOfNew = 0;           ///< behind the last; copies follow, of vertices where holes meet
    std::vector<int> crossing;  ///< new faces that cross others, ascending
    int openRims = 0;           ///< left open, since the boundary of the input is part of them

    /// Values at the vertices, from those of the imprinted mesh: harmonic in a filled hole, see
    /// harmonicFrom().
    [[nodiscard]] std::vector<double> carried(std::span<const double> imprintedValues) const;
};

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
