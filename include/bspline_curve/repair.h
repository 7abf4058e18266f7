// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace bspline_curve {

/// What repairMesh changed; ids are those of the mesh that it was given, ascending.
struct RepairReport {
    /// Vertices and what they were merged into: ends of edges without length, and what was welded.
    std::vector<std::pair<int, int>> mergedVertices;
    /// Faces with a vertex that is nowhere: a coordinate is not finite.
    std::vector<int> leftOutFaces;
    /// Faces with a repeated vertex or no area.
    std::vector<int> removedDegenerateFaces;
    /// Faces across the long side of a flat one, whose third vertex they were split at.
    std::vector<int> splitFaces;
    /// Faces with the same three vertices as an earlier one.
    std::vector<int> removedDuplicateFaces;
    /// Faces turned over, the smaller part of each patch.
    std::vector<int> reversedFaces;
    /// Edges where faces were parted, by their vertices.
    std::vector<std::array<int, 2>> cutEdges;
    /// Seams that were joined, see findSeams(): both edges at each, by their vertices, and the
    /// vertices that became another one there.
    std::vector<std::array<std::array<int, 2>, 2>> joinedEdges;
    std::vector<std::pair<int, int>> joinedVertices;

    struct DuplicatedVertex {
        int vertex;
        std::vector<int> copies;  ///< ids in the result; one part of the surface keeps `vertex`
    };

    std::vector<DuplicatedVertex> duplicatedVertices;

    [[nodiscard]] bool isEmpty() const;
    /// Number of changes, each entry of each list counted once.
    [[nodiscard]] int count() const;
    /// "2 vertices duplicated, 1 edge cut": what was done, for messages; empty where nothing was.
    [[nodiscard]] std::string summary() const;
};

}  // namespace bspline_curve
