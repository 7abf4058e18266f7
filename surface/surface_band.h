// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/surface.h"

#include <span>
#include <vector>

namespace bspline_curve {

/// Some faces of a surface as a surface of its own. Where the surface goes on, the band has a
/// boundary (its rim); vertices and faces keep their order.
struct SurfaceBand {
    Surface surface;
    std::vector<int> faces;     ///< of the whole surface, for each face of the band; ascending
    std::vector<int> vertices;  ///< of the whole surface, for each vertex of the band; ascending

    /// Where a face of the whole surface is in the band; -1 where it is not. O(log n).
    [[nodiscard]] int indexOf(int face) const;
};

/// Cuts faces, in any order, out of a surface. Where the rim would touch itself in a vertex, all
/// faces around this vertex come too, so that the band is a manifold. Throws InputError (EmptyMesh,
/// IndexOutOfRange). O(n log n) for n faces of the band, whatever the size of the whole surface.
[[nodiscard]] SurfaceBand cutBand(const Surface& whole, std::span<const int> faces);

/// The faces nearest to those of a path, these included, ascending: breadth first, faces that share
/// a vertex are neighbours. `count` of them: fewer where the components of the path have no more,
/// more where the path itself has. Throws InputError (EmptyMesh, IndexOutOfRange, BadOption:
/// count < 1). O(n log n) for n faces found.
[[nodiscard]] std::vector<int> facesNear(
    const Surface& surface, std::span<const int> path, int count
);

}  // namespace bspline_curve
