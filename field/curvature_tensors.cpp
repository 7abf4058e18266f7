// SPDX-License-Identifier: GPL-3.0-or-later
#include "field/curvature_tensors.h"

#include "utility/report_progress.h"

#include <Eigen/Geometry>

#include <vcg/complex/algorithms/update/curvature_fitting.h>
#include <vcg/complex/complex.h>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace bspline_curve {

namespace {

// ---- vcglib's mesh ----

class Vertex;
class Face;

struct Types : vcg::UsedTypes<vcg::Use<Vertex>::AsVertexType, vcg::Use<Face>::AsFaceType> {};

class Vertex : public vcg::Vertex<
                   Types,
                   vcg::vertex::Coord3d,
                   vcg::vertex::Normal3d,
                   vcg::vertex::CurvatureDird,
                   vcg::vertex::VFAdj,
                   vcg::vertex::BitFlags> {};

class Face : public vcg::Face<Types, vcg::face::VertexRef, vcg::face::VFAdj, vcg::face::BitFlags> {
};

class Mesh : public vcg::tri::TriMesh<std::vector<Vertex>, std::vector<Face>> {};

using Fitting = vcg::tri::UpdateCurvatureFitting<Mesh>;

/// In units of the mean edge length, so that the normal equations have entries near 1.
void load(Mesh& mesh, const Surface& surface, const std::vector<Vec3>& normals) {
    const Vec3 origin = surface.position({.face = 0, .barycentric = Vec3::UnitX()});
    vcg::tri::Allocator<Mesh>::AddVertices(mesh, surface.vertices().size());
    for (std::size_t v = 0; v < mesh.vert.size(); ++v) {
        const Vec3 p = (surface.vertices()[v] - origin) / surface.averageEdgeLength();
        mesh.vert[v].P() = {p[0], p[1], p[2]};
        mesh.vert[v].N() = {normals[v][0], normals[v][1], normals[v][2]};
    }
    vcg::tri::Allocator<Mesh>::AddFaces(mesh, surface.faces().size());
    for (std::size_t f = 0; f < mesh.face.size(); ++f) {
        for (int k = 0; k < 3; ++k) {
            mesh.face[f].V(k) = &mesh.vert[surface.faces()[f][k]];
        }
    }
    vcg::tri::UpdateTopology<Mesh>::VertexFace(mesh);
}

Vec3 toVec3(const Vertex::CoordType& p) {
    return {p[0], p[1], p[2]};
}

// ---- vertices around a vertex ----

/// Finds the rings of vertices around one vertex after the other, in an order that only depends on
/// the fans of faces.
class RingFinder {
public:
    explicit RingFinder(const Surface& surface)
        : surface_(surface), seenIn_(surface.vertices().size(), 0) {}

    /// The vertices of so many rings, without the centre; valid until the next call.
    const std::vector<int>& around(int centre, int rings) {
        found_.clear();
        ++call_;
        seenIn_[centre] = call_;
        addNeighbours(centre);
        for (int ring = 1; ring < rings; ++ring) {
            const std::size_t end = found_.size();
            for (std::size_t i = 0; i < end; ++i) {
                addNeighbours(found_[i]);
            }
        }
        return found_;
    }

private:
    void addNeighbours(int vertex) {
        for (const int face : surface_.facesAround(vertex)) {
            for (const int corner : surface_.faces()[face]) {
                if (seenIn_[corner] != call_) {
                    seenIn_[corner] = call_;
                    found_.push_back(corner);
                }
            }
        }
    }

    const Surface& surface_;
    std::int64_t call_ = 0;
    std::vector<std::int64_t> seenIn_;  ///< the last call that met each vertex
    std::vector<int> found_;
};

// ---- one fit ----

constexpr std::size_t kFewestPoints =
    5;  // as many as a quadric through the centre has coefficients

/// Less than five points on one ring say too little, as at boundaries.
int ringsAt(const Surface& surface, int vertex, int rings) {
    return surface.facesAround(vertex).size() < static_cast<int>(kFewestPoints) ? 2 : rings;
}

/// Fits a quadric through a vertex to the points around it, and leaves the result in the vertex.
void fitQuadric(Vertex& centre, std::vector<Vertex*>& points) {
    Vertex::CoordType normal;
    Fitting::getAverageNormal(&centre, points, &normal);
    // What faces the other way is another sheet.
    std::vector<Vertex*> facing;
    Fitting::applyProjOnPlane(normal, points, &facing);
    std::vector<Vertex*>& used = facing.size() >= kFewestPoints ? facing : points;
    std::vector<Vertex::CoordType> frame;
    Fitting::computeReferenceFramesLocal(&centre, normal, &frame);
    Fitting::QuadricLocal quadric;
    Fitting::fitQuadricLocal(&centre, frame, used, &quadric);
    Fitting::finalEigenStuff(&centre, frame, quadric);
}

/// The fitted curvatures as a matrix, in 1 / mean edge length.
Eigen::Matrix3d tensorOf(const Vertex& vertex) {
    // The directions come with the length of their curvature: that of the larger one is safe.
    const bool firstIsLarger = std::abs(vertex.cK1()) >= std::abs(vertex.cK2());
    const Vec3 normal = toVec3(vertex.cN());
    const Vec3 larger = toVec3(firstIsLarger ? vertex.cPD1() : vertex.cPD2()).normalized();
    const Vec3 other = normal.cross(larger).normalized();
    const Eigen::Matrix3d tensor =
        (firstIsLarger ? vertex.cK1() : vertex.cK2()) * other * other.transpose() +
        (firstIsLarger ? vertex.cK2() : vertex.cK1()) * larger * larger.transpose();
    return tensor.allFinite() ? tensor : Eigen::Matrix3d::Zero();
}

}  // namespace

std::vector<Eigen::Matrix3d> curvatureTensors(
    const Surface& surface, const std::vector<Vec3>& normals, int rings, const Progress& progress
) {
    constexpr int kReportEvery = 4096;
    Mesh mesh;
    load(mesh, surface, normals);
    std::vector<Eigen::Matrix3d> tensors(surface.vertices().size(), Eigen::Matrix3d::Zero());
    RingFinder finder(surface);
    std::vector<Vertex*> points;
    for (int v = 0; v < surface.vertexCount(); ++v) {
        if (v % kReportEvery == 0) {
            report(progress, static_cast<double>(v) / surface.vertexCount(), "curvature");
        }
        points.clear();
        for (const int id : finder.around(v, ringsAt(surface, v, rings))) {
            points.push_back(&mesh.vert[id]);
        }
        if (points.size() < kFewestPoints) {
            continue;
        }
        Vertex& centre = mesh.vert[v];
        const Vertex::NormalType normal = centre.N();
        fitQuadric(centre, points);
        tensors[v] = tensorOf(centre) / surface.averageEdgeLength();
        centre.N() = normal;  // so that the next fits see the surface's
    }
    return tensors;
}

}  // namespace bspline_curve
