// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/surface.h"

#include <span>
#include <vector>

namespace bspline_curve {

/// (26): the field of obstacles, #V. Outside the region of the given faces (ascending, each once)
/// it is 0; on its boundary `value`; inside the solution of Laplace(Laplace(I)) = 0 that starts
/// with `slope` per diagonal towards the inside. Over a disc of radius r that is value + slope (r^2
/// - rho^2) / (2 r) at the distance rho from the centre, lengths in diagonals. The boundary of the
/// region are the edges between it and other faces; where it ends with the mesh, it goes on as in a
/// mirror. Mixed linear elements with lumped masses and a sparse LDL' factorisation; of second
/// order in the edge length. Over a ragged boundary the hill is lower, by a seventh where that
/// follows a grid. Cotangents are clamped to those of 1 degree, so that slivers
/// cannot ruin the matrix. 2 us per vertex of small regions, 17 in those of
/// 50,000. Throws InputError (BadField): no faces; an id that is no face; a region that covers a
/// component of the surface (first faces of each); no vertex inside a region whose boundary value
/// is 0, where the field would be 0 throughout.
[[nodiscard]] std::vector<double> obstacleField(
    const Surface& surface, std::span<const int> region, double value, double slope
);

}  // namespace bspline_curve
