// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/repair.h"

#include <compare>
#include <span>
#include <utility>

// The steps of repairMesh; each takes what the one before has left.
namespace bspline_curve::repair_steps {

/// Corner k of a face lies opposite to side k, which leads from corner k + 1 to corner k + 2.
struct Side {
    int low, high;  ///< its vertices
    int face, k;
    auto operator<=>(const Side&) const = default;
};

/// All sides of the faces, so that those between the same vertices follow each other.
[[nodiscard]] std::vector<Side> sortedSides(const std::vector<Triangle>& faces);

/// Calls visit(span of sides) for each edge.
template <class Visitor>
void forEachEdge(const std::vector<Side>& sides, const Visitor& visit) {
    for (std::size_t first = 0; first < sides.size();) {
        std::size_t last = first + 1;
        while (last < sides.size() && sides[last].low == sides[first].low &&
               sides[last].high == sides[first].high) {
            ++last;
        }
        visit(std::span<const Side>(sides.data() + first, last - first));
        first = last;
    }
}

/// Whether a side leads from its lower vertex to the higher one.
[[nodiscard]] inline bool leadsUp(const std::vector<Triangle>& faces, const Side& side) {
    return faces[side.face][(side.k + 1) % 3] == side.low;
}

/// Removes or splits away faces without area.
void removeDegenerateFaces(MeshRepair& repair);
void removeDuplicateFaces(MeshRepair& repair);

/// For each face and side the face that it stays joined to, or -1.
using Joints = std::vector<Triangle>;

/// Decides which faces are joined along edges, and turns patches; throws InputError
/// (InconsistentOrientation).
[[nodiscard]] Joints joinAndOrient(MeshRepair& repair);

/// Gives each part of the surface that meets others only in a vertex a vertex of its own.
void splitVertices(MeshRepair& repair, Joints joints);

}  // namespace bspline_curve::repair_steps
