// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/progress.h"
#include "fill/rim_triangulation.h"

#include <cstddef>
#include <limits>
#include <vector>

namespace bspline_curve {

/// A piece of surface that fills a hole. Its first points are those of the rim, which stay.
struct Patch {
    std::vector<Vec3> points;
    std::vector<double> sizes;  ///< for each point the length that edges should have there
    std::vector<double> most;   ///< likewise, far from the rim, whose edges may be shorter
    std::vector<Triangle> faces;
    int rimCount = 0;
    EdgeSet forbidden;  ///< edges between points of the rim that the mesh has already

    [[nodiscard]] bool isOnRim(int point) const { return point < rimCount; }
};

enum class Relaxing {
    Free,        ///< points move to the middle of their neighbours
    Tangential,  ///< within the surface only
    None,        ///< nor are edges flipped, so that the surface stays as it is
};

/// Moves the inner corners of some faces to the middle of their neighbours. O(n).
void relaxAround(Patch& patch, const std::vector<int>& faces);

/// Halves edges that are longer than their points ask for, and long ones between points of the
/// rim; flips edges to Delaunay's; and relaxes points, in turn (after P. Liepa, Filling holes in
/// meshes, 2003). O(n log n) a round, of which there are O(log of the largest length over size).
/// Ends early with more than `mostFaces`. Throws Cancelled.
void refinePatch(
    Patch& patch,
    Relaxing relaxing,
    const Progress& progress = {},
    std::size_t mostFaces = std::numeric_limits<std::size_t>::max()
);

}  // namespace bspline_curve
