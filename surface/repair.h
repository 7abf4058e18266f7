// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"
#include "bspline_curve/repair.h"

#include <Eigen/Core>

#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace bspline_curve {

/// A repaired mesh and where its parts come from. Vertices keep their ids, copies follow them;
/// faces keep their order, but those after a removed one move up.
struct MeshRepair {
    TriangleMesh mesh;
    std::vector<int> vertexOrigins;  ///< #V: vertex of the given mesh
    std::vector<int> faceOrigins;    ///< #F: face of the given mesh
    /// For faces that were reversed or split: column k is corner k in barycentric coordinates of
    /// the origin.
    std::map<int, Eigen::Matrix3d> changedCorners;
    /// For each vertex of the given mesh the lowest of those that it is joined to along seams;
    /// empty where none is.
    std::vector<int> seamRoots;
    /// Likewise along those seams alone that only faces without area had closed before; empty where
    /// there are none.
    std::vector<int> closedSeamRoots;
    /// For each face the given mesh's vertices at its corners, where these are not all the origins
    /// of its vertices, since seams were joined that were open there; else empty. -1: the given
    /// mesh has no vertex there.
    std::vector<Triangle> cornerOrigins;
    /// Edges of faces without area that were removed, by their vertices, ascending.
    std::vector<std::array<int, 2>> removedEdges;
    /// Whether edges of two faces were cut, or seams left open, since the sides of faces disagree
    /// however they are turned.
    bool isOneSided = false;
    RepairReport report;

    /// #V: where vertices of the same place along edges were parted or joined, one for all of them.
    [[nodiscard]] std::vector<int> vertexRoots() const;

    /// The same point as face and barycentric coordinates of the given mesh.
    [[nodiscard]] SurfacePoint toOrigin(const SurfacePoint& point) const;
};

/// Makes a mesh one that Surface accepts, with no more than rounding of its coordinates:
///   faces with a coordinate that is not finite are left out, unless all are such;
///   vertices within `weld` diagonals of each other are merged, where that is not 0;
///   faces without area are removed; their short edge is merged, or the face across the long edge
///   is split, so that no gap stays;
///   of faces with the same vertices only the first stays;
///   where more than two faces meet in an edge, the pairs that bend least stay joined, the others
///   are parted; parts that share a vertex only get a vertex each;
///   one-sided surfaces are cut open;
///   faces on either side of a seam are joined, unless `slits` are to stay;
///   patches are oriented by the majority of their faces.
/// The same input gives the same result. O(n log n).
/// Throws InputError as checkArrays.
[[nodiscard]] MeshRepair repairMesh(TriangleMesh mesh, double weld = 0.0, bool slits = false);

}  // namespace bspline_curve
