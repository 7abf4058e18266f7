// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/shell.h"

#include <vector>

namespace bspline_curve {

/// The prism over a face in a shell of full resolution, whose pillars are numbered like vertices:
/// slots ascending by vertex. Without neighbours.
[[nodiscard]] Prism prismOver(const Triangle& face);

/// Joins prisms over neighbouring faces across their walls, but for those whose orientation is 0
/// (blocked). Prism i lies over face i; `faceNeighbours` as in ExtendedSurface. O(n).
void connectPrisms(std::vector<Prism>& prisms, const std::vector<Triangle>& faceNeighbours);

}  // namespace bspline_curve
