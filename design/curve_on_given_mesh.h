// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "surface/repair.h"

#include <cstddef>
#include <span>
#include <vector>

namespace bspline_curve {

// From a mesh that was mended by `repair` to the mesh as it was given. Null: it was not mended, and
// nothing changes. PointsOnMended and facesOfMended() lead the other way.

/// Gives a polyline the faces of the given mesh, with the barycentric coordinates of its points
/// there.
void bringBack(SurfacePolyline& line, const MeshRepair* repair);

/// Gives a curve the faces of the given mesh: its polyline, and its report.
void bringBack(Curve& curve, const MeshRepair* repair);

/// A flag per face as one per face of the given mesh, which has `givenFaces`: set where that of one
/// of its parts is.
[[nodiscard]] std::vector<char> flagsOfGiven(
    std::vector<char> flags, std::size_t givenFaces, const MeshRepair* repair
);

/// The faces of the mended mesh that come from some faces of the given one, ascending.
[[nodiscard]] std::vector<int> facesOfMended(std::span<const int> faces, const MeshRepair& repair);

}  // namespace bspline_curve
