// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"
#include "bspline_curve/options.h"
#include "bspline_curve/progress.h"
#include "surface/provenance.h"

#include <vector>

namespace bspline_curve {

/// A validated, immutable triangle surface: finite, oriented, two-manifold, every face with area.
/// Boundaries, several components and unreferenced vertices are allowed; these may be anywhere, and
/// need not be finite. Whether it crosses itself
/// is not part of the validation (see self_intersection.h), since that only matters where the curve
/// goes. It knows the mesh that it was made from, its input: Provenance leads there and back. Ids
/// of vertices and faces here are the surface's own; those of users are the input's.
class Surface {
public:
    /// Validates and takes over a mesh. O(n log n) time, on two threads where there are many faces,
    /// on which the result does not depend.
    /// Throws InputError (EmptyMesh, NonFiniteCoordinate, IndexOutOfRange, DegenerateFace,
    /// NonManifoldEdge, InconsistentOrientation, NonManifoldVertex, checked in this order), naming
    /// the count, the first element ids, and what to do; Cancelled.
    explicit Surface(TriangleMesh mesh, const Progress& progress = {});

    /// Likewise; a mesh that would be refused is mended first where that helps, and seams are
    /// joined, see repairMesh(). One that is fine costs hardly more. Throws also InputError
    /// (BadOption).
    Surface(TriangleMesh input, const MendingOptions& mending, const Progress& progress = {});

    /// Likewise, for a mesh that was made of another surface's own.
    Surface(TriangleMesh mesh, Provenance provenance, const Progress& progress = {});

    [[nodiscard]] const TriangleMesh& mesh() const { return mesh_; }

    [[nodiscard]] const Provenance& provenance() const { return provenance_; }

    /// Whether it was made so that edges that lie on each other may be slits.
    [[nodiscard]] bool leavesSlits() const { return leavesSlits_; }

    /// The mesh that the surface was made from.
    [[nodiscard]] const TriangleMesh& input() const {
        return provenance_.isIdentity() ? mesh_ : *provenance_.input();
    }

    [[nodiscard]] const std::vector<Vec3>& vertices() const { return mesh_.vertices; }

    [[nodiscard]] const std::vector<Triangle>& faces() const { return mesh_.faces; }

    [[nodiscard]] int vertexCount() const { return static_cast<int>(mesh_.vertices.size()); }

    [[nodiscard]] int faceCount() const { return static_cast<int>(mesh_.faces.size()); }

    /// For each face its neighbours: entry k lies across the edge opposite to the face's vertex k;
    /// -1 on the boundary.
    [[nodiscard]] const std::vector<Triangle>& faceNeighbours() const { return faceNeighbours_; }

    /// Connected component of each face (faces that share an edge), numbered from 0 in order of
    /// first face.
    [[nodiscard]] const std::vector<int>& faceComponents() const { return faceComponents_; }

    [[nodiscard]] int componentCount() const { return componentCount_; }

    /// Faces around a vertex in counter-clockwise order; at a boundary vertex from the first face
    /// (no neighbour clockwise) to the last. Empty for an unreferenced vertex. A view into one
    /// shared array.
    struct FaceRange {
        const int* first;
        const int* last;

        [[nodiscard]] const int* begin() const { return first; }

        [[nodiscard]] const int* end() const { return last; }

        [[nodiscard]] int size() const { return static_cast<int>(last - first); }

        [[nodiscard]] bool empty() const { return first == last; }
    };

    [[nodiscard]] FaceRange facesAround(int vertex) const {
        return {
            vertexFaces_.data() + vertexFaceOffsets_[vertex],
            vertexFaces_.data() + vertexFaceOffsets_[vertex + 1]
        };
    }

    [[nodiscard]] bool isBoundaryVertex(int vertex) const { return isBoundaryVertex_[vertex] != 0; }

    /// Length of the diagonal of the axis-aligned box of the referenced vertices.
    [[nodiscard]] double diagonal() const { return diagonal_; }

    /// Sum of the areas of all faces.
    [[nodiscard]] double area() const { return area_; }

    /// Mean length of all edges, each counted once.
    [[nodiscard]] double averageEdgeLength() const { return averageEdgeLength_; }

    [[nodiscard]] Vec3 position(const SurfacePoint& point) const;
    /// Unit normal of a face, right-handed.
    [[nodiscard]] Vec3 faceNormal(int face) const;

private:
    void validate(const Progress& progress);

    TriangleMesh mesh_;
    Provenance provenance_;
    bool leavesSlits_ = false;
    std::vector<Triangle> faceNeighbours_;
    std::vector<int> faceComponents_;
    int componentCount_ = 0;
    std::vector<int> vertexFaceOffsets_;
    std::vector<int> vertexFaces_;
    std::vector<char> isBoundaryVertex_;
    double diagonal_ = 0.0;
    double area_ = 0.0;
    double averageEdgeLength_ = 0.0;
};

}  // namespace bspline_curve
