// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "surface/repair.h"

#include <span>
#include <vector>

namespace bspline_curve {

/// Gives a polyline on a mended mesh the faces of the mesh as it was given, with the barycentric
/// coordinates of its points there. PointsOnMended leads the other way.
void bringBack(SurfacePolyline& line, const MeshRepair& repair);

/// Gives a curve on a mended mesh the faces of the mesh as it was given: its polyline,
/// and its report.
void bringBack(Curve& curve, const MeshRepair& repair);

/// The faces of the mended mesh that come from some faces of the given one, ascending.
[[nodiscard]] std::vector<int> facesOfMended(std::span<const int> faces, const MeshRepair& repair);

}  // namespace bspline_curve
