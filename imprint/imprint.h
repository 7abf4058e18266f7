// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "surface/surface.h"

#include <span>
#include <vector>

namespace bspline_curve {

struct ImprintOptions {
    /// Points nearer than this to each other, to an edge, a vertex or another curve are taken as
    /// one with it, in [0, 0.01]: in barycentric coordinates, so relative to the altitudes of a
    /// face, and on an edge to its length. Where a new face would be flat or turned over, the
    /// distance is widened in its parent. 0: nothing is moved but by rounding.
    double snap = 1e-9;

    /// Throws InputError (BadOption).
    void validate() const;
};

struct ImprintedCurve {
    bool closed = false;
    /// Vertices of the imprinted mesh in order, joined by edges; a closed curve does not repeat the
    /// first one. One vertex only where the whole curve was snapped to it.
    std::vector<int> vertices;
};

/// A mesh with curves as edges. Parents and places are those of the surface's input.
struct ImprintedMesh {
    /// The input's vertices first, as they were; then corners that mending has doubled; then those
    /// of curves on edges and in faces. The children of a face stand where their parent stood.
    TriangleMesh mesh;
    std::vector<int> parents;               ///< for each face, the input face that it is part of
    std::vector<SurfacePoint> newVertices;  ///< for each new vertex, its place on the input
    std::vector<int> doubledVertices;    ///< likewise, the input's vertex that it doubles; -1: none
    std::vector<ImprintedCurve> curves;  ///< in the order of the input
    /// Vertices where curves cross, touch, part or end on each other, ascending: where more than
    /// two edges of curves meet.
    std::vector<int> crossings;
    int dividedFaces = 0;
    double largestMove = 0.0;  ///< by snapping and rounding, in the user's unit

    /// The same with the ids of the surface itself: its vertices come first; for each face that of
    /// the surface, for each further vertex its place there.
    int surfaceVertexCount = 0;
    std::vector<int> ownParents;
    std::vector<SurfacePoint> ownPlaces;
};

/// Makes the curves edges of the mesh. Divides only faces that a curve passes, each into a
/// constrained Delaunay triangulation; all new faces have area and their parent's orientation,
/// decided by exact signs for the vertices as rounded. Curves may cross themselves and each other,
/// and run along edges and through vertices; their order does not matter. Imprinting what is
/// imprinted changes nothing. O(n log n) for n segments, beside a copy of the mesh. Throws
/// InputError (BadOption; NoPath where a curve is not strictly on the surface, or where new faces
/// would be flat for any snapping distance); the surface is not touched. Curves are on its input.
[[nodiscard]] ImprintedMesh imprint(
    const Surface& surface, std::span<const SurfacePolyline> curves, const ImprintOptions& options
);

/// The same for curves with the surface's own faces; parents and places are its own ones alone.
[[nodiscard]] ImprintedMesh imprintOwn(
    const Surface& surface, std::span<const SurfacePolyline> curves, const ImprintOptions& options
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

/// An imprinted curve as a polyline on the imprinted mesh, whose surface is given.
[[nodiscard]] SurfacePolyline polylineOf(const Surface& imprinted, const ImprintedCurve& curve);

}  // namespace bspline_curve
