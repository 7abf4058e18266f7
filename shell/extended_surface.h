// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/progress.h"
#include "surface/surface.h"

#include <vector>

namespace bspline_curve {

class PatchLevels;

/// Rigid-scale frame of the shell: unit = (user - centre) / scale.
struct ShellFrame {
    Vec3 centre = Vec3::Zero();
    double scale = 1.0;

    [[nodiscard]] Vec3 toUnit(const Vec3& user) const { return (user - centre) / scale; }

    [[nodiscard]] Vec3 toUser(const Vec3& unit) const { return unit * scale + centre; }
};

/// What the shell is built around: the surface in the shell's frame, with the same connectivity, a
/// few vertices moved so that every vertex sees all its faces from some direction, and a strip of
/// ghost faces beyond each boundary.
struct ExtendedSurface {
    ShellFrame frame;
    std::vector<Vec3> vertices;            ///< those of the surface, then ghosts
    std::vector<Triangle> faces;           ///< those of the surface, then ghosts
    std::vector<Triangle> faceNeighbours;  ///< as Surface::faceNeighbours, over all faces
    std::vector<Vec3> directions;          ///< unit pillar direction of each vertex
    /// Mean normal of the faces at each vertex of the surface, by area: unit, or zero where its
    /// faces have no area. Not smoothed and not turned, as the directions are. For curvature.
    std::vector<Vec3> normals;
    /// Mean length of the edges at each vertex; 0 at unreferenced ones.
    std::vector<double> edgeLengths;
    int surfaceVertexCount = 0, surfaceFaceCount = 0;
    std::vector<int>
        ghostSource;  ///< boundary vertex that ghost vertex surfaceVertexCount + i grew from
    std::vector<int>
        movedVertices;  ///< vertices of the surface that had to move (singular vertices)
    std::vector<int> unseenVertices;  ///< vertices that got no direction all the same

    [[nodiscard]] Vec3 position(const SurfacePoint& point) const {
        const Triangle& face = faces[point.face];
        return point.barycentric[0] * vertices[face[0]] + point.barycentric[1] * vertices[face[1]] +
               point.barycentric[2] * vertices[face[2]];
    }

    /// The normal at a point, linear in those of the vertices over its face; not unit.
    [[nodiscard]] Vec3 normalAt(int face, const Vec3& barycentric) const {
        Vec3 sum = Vec3::Zero();
        for (int corner = 0; corner < 3; ++corner) {
            sum += barycentric[corner] * vertexNormal(faces[face][corner]);
        }
        return sum;
    }

    /// Of a vertex, ghosts too.
    [[nodiscard]] const Vec3& vertexNormal(int vertex) const {
        return normals[surfaceVertex(vertex)];
    }

    /// The vertex of the surface behind a vertex: itself, or the boundary vertex that a ghost grew
    /// from.
    [[nodiscard]] int surfaceVertex(int vertex) const {
        return vertex < surfaceVertexCount ? vertex : ghostSource[vertex - surfaceVertexCount];
    }
};

/// Smallest cosine between a pillar direction and the normals of the faces around it that is
/// accepted.
inline constexpr double kLeastPillarCosine = 0.05;

/// Longest side of the box of the surface's faces, in the shell's frame.
[[nodiscard]] double longestSideOf(const ExtendedSurface& extended);

/// Longest side of the box of the surface's faces, in the user's unit.
[[nodiscard]] double longestSideOf(const Surface& surface);

/// A base without ghosts, whose directions are not smooth yet.
struct RoughBase {
    ExtendedSurface extended;
    std::vector<Vec3> faceNormals;  ///< unit
};

/// Moves singular vertices and finds directions, in the frame in which the surface's box is centred
/// at the origin and its diagonal is 1. O(n). Throws Cancelled.
[[nodiscard]] RoughBase makeRoughBase(const Surface& surface, const Progress& progress = {});

/// Smooths directions and adds ghosts. Where faces are small they are smoothed over patches of them
/// first (see patchesToSmoothOver()), so that they are as smooth on every resolution. O(n). Throws
/// Cancelled.
[[nodiscard]] ExtendedSurface extendSurface(
    const Surface& surface,
    RoughBase rough,
    int smoothingPasses,
    const PatchLevels& patches,
    const Progress& progress = {}
);

/// All of that.
[[nodiscard]] ExtendedSurface extendSurface(
    const Surface& surface, int smoothingPasses, const Progress& progress = {}
);

}  // namespace bspline_curve
