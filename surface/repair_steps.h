// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/passages.h"
#include "surface/repair.h"

// The steps of repairMesh; each takes what the one before has left.
namespace bspline_curve::repair_steps {

/// Merges vertices within a distance of each other; faces may be left without area.
void weldVertices(MeshRepair& repair, double distance);

/// Removes or splits away faces without area.
void removeDegenerateFaces(MeshRepair& repair);
void removeDuplicateFaces(MeshRepair& repair);

/// For each half-edge the face that it stays joined to, by face and k, or -1.
using Joints = std::vector<Triangle>;

/// Decides which faces are joined along edges, those of the passages (ascending) first, and turns
/// patches.
[[nodiscard]] Joints joinAndOrient(MeshRepair& repair, const std::vector<Passage>& passages = {});

/// Gives each part of the surface that meets others only in a vertex a vertex of its own.
void splitVertices(MeshRepair& repair, Joints joints, const std::vector<Passage>& passages = {});

}  // namespace bspline_curve::repair_steps
