// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "design/line_smoother.h"
#include "shell/extended_surface.h"
#include "solver/curve_problem.h"
#include "surface/surface.h"

#include <span>

namespace bspline_curve {

/// In the shell's frame.
struct PieceLengths {
    double longest;  ///< longer pieces of a line count as several points
    double whole;  ///< shorter ones count less, so that it hardly matters how densely it is sampled
};

/// Finds the points that a line is known by, from its path and its vertices.
///
/// Of a piece between two vertices that is the middle, which steps from one side to the other
/// disturb less than the vertices. A piece that is an edge of the mesh says more: such lines part
/// faces, of which one side was taken by its middle and the other was not. So the line that was
/// meant passes somewhere between the middles of the two faces, and is known by the point halfway
/// between them, the better, the closer they are: the weight falls with the square of that
/// distance.
///
/// Returns the share of the line's length that runs along edges. O(1) for each vertex.
double findLinePoints(
    const Surface& surface,
    const ExtendedSurface& extended,
    std::span<const PickConstraint> vertices,
    const PieceLengths& lengths,
    MeasuredLine& line
);

}  // namespace bspline_curve
