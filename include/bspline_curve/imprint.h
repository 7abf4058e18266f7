// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/curve.h"
#include "bspline_curve/mesh.h"
#include "bspline_curve/progress.h"
#include "bspline_curve/workpiece.h"

#include <memory>
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

/// What the curves of an imprint part the mesh into.
struct MeshPart {
    int faces = 0;
    double area = 0.0;
    double perimeter = 0.0;  ///< length of its rim: curves and the mesh's own boundary
    Vec3 centroid = Vec3::Zero();
    /// V - E + F with vertices and edges of a curve counted once on each side of it: 1 for a disc,
    /// 2 for a sphere, 0 for a ring.
    int euler = 0;
};

struct MeshParts {
    std::vector<int> labels;  ///< for each face of the imprinted mesh its part
    std::vector<MeshPart> parts;
    /// Where strokes were imprinted: the parts (ascending) within half the width of the lines.
    std::vector<int> strokes{};
};

/// Curves as edges of the workpiece's mesh, and the parts between them.
struct Imprint {
    /// With the vertices of the workpiece's mesh.
    std::shared_ptr<const ImprintedMesh> mesh;
    /// The same one, but where mending has joined seams of the workpiece's mesh: with these joined,
    /// as parts are found and cut out.
    std::shared_ptr<const ImprintedMesh> joined;
    MeshParts parts;
    double seconds = 0.0;  ///< of imprinting, without finding parts

    /// What it was made on, for the library itself.
    struct Source;
    std::shared_ptr<const Source> source;
};

/// Makes the lines edges of the mesh. Divides only faces that a line passes, each into a
/// constrained Delaunay triangulation; all new faces have area and their parent's orientation,
/// decided by exact signs for the vertices as rounded. Lines may cross themselves and each other,
/// and run along edges and through vertices; their order does not matter. Imprinting what is
/// imprinted changes nothing. O(n log n) for n segments, beside a copy of the mesh. Throws
/// InputError (BadOption; NoPath where a line is not strictly on the mesh, or where new faces would
/// be flat for any snapping distance), Cancelled.
[[nodiscard]] Imprint imprintOn(
    const Workpiece& workpiece,
    std::span<const SurfacePolyline> lines,
    const ImprintOptions& options = {},
    const Progress& progress = {}
);

/// Lines drawn with a width: makes the lines at half of it, along the surface, edges of the mesh,
/// on both sides and round the ends of open ones. Together they bound what is nearer to any of the
/// lines, so that strokes may cross. PartChoice::Which::Inside then means the strokes. `width`: in
/// the user's unit. Throws likewise; InputError (BadOption: the width; NoPath where no point of the
/// mesh is as far from the lines).
[[nodiscard]] Imprint strokesOn(
    const Workpiece& workpiece,
    std::span<const SurfacePolyline> lines,
    double width,
    const ImprintOptions& options = {},
    const Progress& progress = {}
);

}  // namespace bspline_curve
