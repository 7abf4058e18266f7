// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <vector>

/// Meshes for tests, chosen by property. All are oriented outwards (plates: towards +z) and
/// two-manifold, except for the defects at the end.
namespace bspline_curve::test_support {

// ---- Open surfaces ----

/// The rectangle [0, width] x [0, height] in the plane z = 0, columns x rows cells of two faces
/// each; the diagonals alternate, so that no direction is preferred. Vertex (i, j) has index
/// j * (columns + 1) + i.
TriangleMesh plate(int columns, int rows, double width = 1.0, double height = 1.0);

/// A plate whose inner vertices are moved in its plane, by up to `amount` (< 0.3) of a cell.
TriangleMesh jitteredPlate(int columns, int rows, double amount, std::uint64_t seed);

/// A cylinder about the z axis, from z = 0 to z = height, without lids.
TriangleMesh openCylinder(int segments, int rings, double radius = 1.0, double height = 2.0);

// ---- Closed surfaces ----

/// A sphere about the origin: an icosahedron, each face split into four `subdivisions` times,
/// vertices on the sphere: 20 * 4^subdivisions faces.
TriangleMesh icosphere(int subdivisions, double radius = 1.0);

/// A torus about the z axis.
TriangleMesh torus(
    int majorSegments, int minorSegments, double majorRadius = 1.0, double minorRadius = 0.3
);

/// The box from 0 to `lengths`, each side cellsPerSide x cellsPerSide cells, vertices shared along
/// its edges.
TriangleMesh box(int cellsPerSide, const Vec3& lengths = Vec3::Ones());

/// The unit box, narrower towards the bottom: its side over x = 1 makes an angle of 73 degrees with
/// the top.
TriangleMesh wedge(int cellsPerSide);

/// Two unit icospheres of 80 faces each, centres 4 apart along x.
TriangleMesh twoComponents();

// ---- Changes ----

/// Every face split into four at the midpoints of its edges: the same surface.
TriangleMesh midpointSubdivide(const TriangleMesh& mesh);

/// Scaled about the origin first, then moved.
TriangleMesh transformed(
    const TriangleMesh& mesh, const Eigen::Isometry3d& motion, double scale = 1.0
);

/// Every vertex moved by up to `amplitude` along each axis.
TriangleMesh withNoise(TriangleMesh mesh, double amplitude, std::uint64_t seed);

/// The same surface with vertices and faces in random order, and every face starting at a random
/// corner.
TriangleMesh renumbered(const TriangleMesh& mesh, std::uint64_t seed);

/// One mesh after the other; the indices of the second are moved up.
TriangleMesh joined(const TriangleMesh& first, const TriangleMesh& second);

/// Each face has its vertices for itself and those of its label: seams between labels. The faces of
/// the first label at a vertex keep it.
TriangleMesh partedByLabels(TriangleMesh mesh, const std::vector<int>& labels);

/// The faces over a half-plane through the z axis get vertices of their own along it: a seam from
/// pole to pole where the mesh is a sphere of rings.
TriangleMesh slitAlongZ(TriangleMesh mesh);

/// One face turned over.
TriangleMesh withFaceReversed(TriangleMesh mesh, int face);

// ---- Defects ----

/// Three faces around the edge (0, 1).
TriangleMesh threeFacesAtAnEdge();

/// Two triangles that share vertex 0 only.
TriangleMesh bowTie();

/// A one-sided strip with consistently oriented neighbours except across one edge.
TriangleMesh moebiusStrip(int segments);

/// Two plates of 4 x 4 cells that cross at right angles and share no vertex.
TriangleMesh crossingPlates();

}  // namespace bspline_curve::test_support
