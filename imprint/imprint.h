// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/imprint.h"
#include "surface/surface.h"
#include "utility/go_on.h"

#include <span>
#include <vector>

namespace bspline_curve {

/// Makes the curves edges of the mesh. Divides only faces that a curve passes, each into a
/// constrained Delaunay triangulation; all new faces have area and their parent's orientation,
/// decided by exact signs for the vertices as rounded. Curves may cross themselves and each other,
/// and run along edges and through vertices; their order does not matter. Imprinting what is
/// imprinted changes nothing. O(n log n) for n segments, beside a copy of the mesh. Throws
/// InputError (BadOption; NoPath where a curve is not strictly on the surface, or where new faces
/// would be flat for any snapping distance), and what `goOn` throws; the surface is not touched.
/// Curves are on its input.
[[nodiscard]] ImprintedMesh imprint(
    const Surface& surface,
    std::span<const SurfacePolyline> curves,
    const ImprintOptions& options,
    const GoOn& goOn = [] {}
);

/// The same for curves with the surface's own faces; parents and places are its own ones alone.
[[nodiscard]] ImprintedMesh imprintOwn(
    const Surface& surface,
    std::span<const SurfacePolyline> curves,
    const ImprintOptions& options,
    const GoOn& goOn = [] {}
);

/// Where a corner of a face is on the surface that was imprinted, in the face that it is part of.
[[nodiscard]] SurfacePoint ownPlace(
    const Surface& surface, const ImprintedMesh& imprinted, int face, int corner
);

/// The surface's mesh without its imprint: as it was, bit for bit. O(n).
[[nodiscard]] TriangleMesh withoutImprint(const ImprintedMesh& imprinted);

/// Values at the vertices of the imprinted mesh, from those at the input's: linear in each input
/// face. O(n).
[[nodiscard]] std::vector<double> interpolated(
    const ImprintedMesh& imprinted,
    const std::vector<Triangle>& inputFaces,
    std::span<const double> values
);

/// Vectors at the vertices of the imprinted mesh, from those at the vertices of withoutImprint():
/// linear in each of its faces, which are given. O(n).
[[nodiscard]] std::vector<Vec3> interpolatedOwn(
    const ImprintedMesh& imprinted, const std::vector<Triangle>& ownFaces, std::vector<Vec3> vectors
);

/// An imprinted curve as a polyline on the imprinted mesh, whose surface is given.
[[nodiscard]] SurfacePolyline polylineOf(const Surface& imprinted, const ImprintedCurve& curve);

}  // namespace bspline_curve
