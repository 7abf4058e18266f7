// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/surface.h"

#include "surface/face_adjacency.h"
#include "surface/mesh_checks.h"

#include <Eigen/Geometry>

#include <utility>

namespace bspline_curve {

namespace {

double diagonalOfReferencedVertices(const TriangleMesh& mesh) {
    Eigen::AlignedBox3d box;
    for (const Triangle& face : mesh.faces) {
        for (const int vertex : face) {
            box.extend(mesh.vertices[static_cast<std::size_t>(vertex)]);
        }
    }
    return box.diagonal().norm();
}

}  // namespace

Surface::Surface(TriangleMesh mesh) : mesh_(std::move(mesh)) {
    checkArrays(mesh_);
    checkFacesHaveArea(mesh_);

    FaceAdjacency adjacency = joinFacesAlongEdges(mesh_);
    faceNeighbours_ = std::move(adjacency.neighbours);
    averageEdgeLength_ = adjacency.averageEdgeLength;

    VertexFans fans = orderFacesAroundVertices(mesh_, faceNeighbours_);
    vertexFaceOffsets_ = std::move(fans.offsets);
    vertexFaces_ = std::move(fans.faces);
    isBoundaryVertex_ = std::move(fans.isBoundary);

    FaceComponents components = labelComponents(faceNeighbours_);
    faceComponents_ = std::move(components.componentOf);
    componentCount_ = components.count;

    diagonal_ = diagonalOfReferencedVertices(mesh_);
}

Vec3 Surface::position(const SurfacePoint& point) const {
    const Triangle& face = mesh_.faces[static_cast<std::size_t>(point.face)];
    return point.barycentric[0] * mesh_.vertices[static_cast<std::size_t>(face[0])] +
           point.barycentric[1] * mesh_.vertices[static_cast<std::size_t>(face[1])] +
           point.barycentric[2] * mesh_.vertices[static_cast<std::size_t>(face[2])];
}

Vec3 Surface::faceNormal(int face) const {
    const Triangle& corners = mesh_.faces[static_cast<std::size_t>(face)];
    const Vec3& origin = mesh_.vertices[static_cast<std::size_t>(corners[0])];
    const Vec3 edge1 = mesh_.vertices[static_cast<std::size_t>(corners[1])] - origin;
    const Vec3 edge2 = mesh_.vertices[static_cast<std::size_t>(corners[2])] - origin;
    return edge1.cross(edge2).normalized();
}

}  // namespace bspline_curve
