// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "surface/surface.h"

#include <span>
#include <vector>

namespace bspline_curve {

struct MeshRepair;

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

/// A mesh with curves as edges.
struct ImprintedMesh {
    /// Input vertices first, as they were; then those on edges and those in faces. The children of
    /// a face stand where their parent stood.
    TriangleMesh mesh;
    std::vector<int> parents;               ///< for each face, the input face that it is part of
    std::vector<SurfacePoint> newVertices;  ///< for each new vertex, its place on the input
    std::vector<ImprintedCurve> curves;     ///< as they were given
    /// Vertices where curves cross, touch, part or end on each other, ascending: where more than
    /// two edges of curves meet.
    std::vector<int> crossings;
    int dividedFaces = 0;
    double largestMove = 0.0;  ///< by snapping and rounding, in the user's unit

    [[nodiscard]] int inputVertexCount() const {
        return static_cast<int>(mesh.vertices.size() - newVertices.size());
    }
};

/// Makes the curves edges of the mesh. Divides only faces that a curve passes, each into a
/// constrained Delaunay triangulation; all new faces have area and their parent's orientation,
/// decided by exact signs for the vertices as rounded. Curves may cross themselves and each other,
/// and run along edges and through vertices; their order does not matter. Imprinting what is
/// imprinted changes nothing. O(n log n) for n segments, beside a copy of the mesh. Throws
/// InputError (BadOption; NoPath where a curve is not strictly on the surface, or where new faces
/// would be flat for any snapping distance); the input is not touched.
[[nodiscard]] ImprintedMesh imprint(
    const Surface& surface, std::span<const SurfacePolyline> curves, const ImprintOptions& options
);

/// The mesh without its imprint: as it was, bit for bit. O(n).
[[nodiscard]] TriangleMesh withoutImprint(const ImprintedMesh& imprinted);

/// Values at the vertices of the imprinted mesh, from those at the input's: linear in each input
/// face. O(n).
[[nodiscard]] std::vector<double> interpolated(
    const ImprintedMesh& imprinted,
    const std::vector<Triangle>& inputFaces,
    std::span<const double> values
);

/// Where an imprint comes from. For one on a mesh that was mended: in the mesh as it was given.
struct ImprintOrigins {
    std::vector<int> parents;  ///< for each face, the given face that it is part of
    /// For each vertex after the given ones, its place on the given mesh; first are those that
    /// mending doubled, at a corner.
    std::vector<SurfacePoint> newVertices;
};

/// `input`: what was imprinted. `repair`: how it was mended; null: it was not. O(n).
[[nodiscard]] ImprintOrigins originsOf(
    const ImprintedMesh& imprinted, const Surface& input, const MeshRepair* repair
);

/// An imprinted curve as a polyline on the imprinted mesh, whose surface is given.
[[nodiscard]] SurfacePolyline polylineOf(const Surface& imprinted, const ImprintedCurve& curve);

}  // namespace bspline_curve
