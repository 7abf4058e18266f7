// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/passages.h"
#include "surface/repair.h"
#include "surface/seams.h"

// The steps of repairMesh; each takes what the one before has left.
namespace bspline_curve::repair_steps {

/// Leaves out faces at vertices that are nowhere, where others are left.
void leaveOutFaces(MeshRepair& repair);

/// Merges vertices within a distance of each other; faces may be left without area.
void weldVertices(MeshRepair& repair, double distance);

/// Removes or splits away faces without area.
void removeDegenerateFaces(MeshRepair& repair);
void removeDuplicateFaces(MeshRepair& repair);

/// Divides a face at a vertex on its side k, which stays the side k of both parts. Returns the new
/// part, at corner k + 2. `share`: of the side, how far the vertex is from corner k + 1.
int divideFace(MeshRepair& repair, int face, int k, int vertex, double share);

/// For each half-edge the face that it stays joined to, by face and k, or -1.
using Joints = std::vector<Triangle>;

/// Decides which faces are joined along edges, and turns patches: first those of the passages, in
/// their order, then where two faces meet, from the passages outwards, then along seams, at last
/// where more faces meet. Vertices that are joined along seams get the roots of `seamRoots`.
[[nodiscard]] Joints joinAndOrient(
    MeshRepair& repair, const std::vector<Passage>& passages, const std::vector<Seam>& seams
);

/// What happens to faces at edges that stay crowded since both ends are held together by faces
/// around them.
enum class Crowded : char {
    CutOut,  ///< they are parted from their neighbours at one end
    Divide,  ///< the edge is divided: they get a vertex between its ends; cut where it is too short
};

/// Gives each part of the surface that meets others only in a vertex a vertex of its own: of those
/// that it had the lowest that no larger part keeps, or a copy. At crowded edges the passages stay
/// as they are.
void splitVertices(
    MeshRepair& repair, Joints joints, Crowded crowded, std::vector<Passage> passages = {}
);

}  // namespace bspline_curve::repair_steps
