// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/surface.h"

#include "bspline_curve/error.h"
#include "bspline_curve/progress.h"
#include "surface/face_adjacency.h"
#include "surface/mesh_checks.h"
#include "surface/repair.h"
#include "surface/seams.h"
#include "surface/surface_point.h"
#include "utility/worker_task.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <optional>
#include <tuple>
#include <utility>

namespace bspline_curve {

namespace {

double diagonalOfReferencedVertices(const TriangleMesh& mesh, const std::vector<int>& faceOffsets) {
    Eigen::AlignedBox3d box;
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        if (faceOffsets[v] < faceOffsets[v + 1]) {
            box.extend(mesh.vertices[v]);
        }
    }
    return box.diagonal().norm();
}

/// How the faces join, and their area. Throws InputError, Cancelled. A mesh that is refused may be
/// mended and come again, so the fraction stays at 0: it must not fall.
std::pair<FaceAdjacency, double> validated(const TriangleMesh& mesh, const Progress& progress) {
    report(progress, 0.0, kPreparingStage);
    checkArrays(mesh);

    // Listing only needs indices in range, so that it need not wait for the areas.
    auto listed = startBeside(mesh.faces.size(), [&mesh] { return listFacesAtVertices(mesh); });
    const double area = checkFacesHaveArea(mesh);
    VertexFaces at = listed.get();
    report(progress, 0.0, kPreparingStage);
    return {joinFaces(mesh, std::move(at)), area};
}

/// Whether repairMesh can mend what a mesh was refused for.
bool canBeMended(InputErrorCode code) {
    return code == InputErrorCode::NonFiniteCoordinate || code == InputErrorCode::DegenerateFace ||
           code == InputErrorCode::NonManifoldEdge || code == InputErrorCode::NonManifoldVertex ||
           code == InputErrorCode::InconsistentOrientation;
}

}  // namespace

void MendingOptions::validate() const {
    if (strict && weld > 0.0) {
        throw InputError(
            InputErrorCode::BadOption,
            "the options strict and weld exclude each other: one takes a mesh as it is, the other "
            "joins its vertices; choose one"
        );
    }
}

Surface::Surface(TriangleMesh mesh, const Progress& progress) : mesh_(std::move(mesh)) {
    validate(progress);
}

Surface::Surface(TriangleMesh mesh, Provenance provenance, const Progress& progress)
    : mesh_(std::move(mesh)), provenance_(std::move(provenance)) {
    validate(progress);
}

Surface::Surface(TriangleMesh input, const MendingOptions& mending, const Progress& progress)
    : mesh_(std::move(input)), leavesSlits_(mending.strict || mending.slits) {
    mending.validate();
    std::optional<InputError> refusal;
    if (mending.weld == 0.0 && (leavesSlits_ || findSeams(mesh_).empty())) {
        try {
            validate(progress);
            return;
        } catch (const InputError& error) {
            if (!canBeMended(error.code())) {
                throw;
            }
            refusal.emplace(
                error.code(), error.what(), error.elements(), Remedy{.kind = Remedy::Kind::Mend}
            );
        }
    }
    MeshRepair repair = repairMesh(mesh_, mending.weld, mending.slits);
    TriangleMesh given = std::exchange(mesh_, std::move(repair.mesh));
    if (!repair.report.isEmpty()) {
        provenance_ = Provenance(std::move(given), std::move(repair), refusal);
    }
    try {
        validate(progress);
    } catch (const InputError&) {
        if (refusal) {
            throw InputError(refusal->code(), refusal->what(), refusal->elements());
        }
        throw;
    }
    if (mending.strict && refusal) {
        throw InputError(*refusal);
    }
}

void Surface::validate(const Progress& progress) {
    FaceAdjacency adjacency;
    std::tie(adjacency, area_) = validated(mesh_, progress);
    report(progress, 0.8, kPreparingStage);
    faceNeighbours_ = std::move(adjacency.neighbours);
    averageEdgeLength_ = adjacency.averageEdgeLength;
    vertexFaceOffsets_ = std::move(adjacency.facesAround.offsets);
    vertexFaces_ = std::move(adjacency.facesAround.faces);
    isBoundaryVertex_ = std::move(adjacency.isBoundary);

    auto labelled =
        startBeside(mesh_.faces.size(), [this] { return labelComponents(faceNeighbours_); });
    diagonal_ = diagonalOfReferencedVertices(mesh_, vertexFaceOffsets_);
    std::tie(faceComponents_, componentCount_) = labelled.get();
}

Vec3 Surface::position(const SurfacePoint& point) const {
    return positionOf(mesh_, point);
}

Vec3 Surface::faceNormal(int face) const {
    const Triangle& corners = mesh_.faces[face];
    const Vec3& origin = mesh_.vertices[corners[0]];
    const Vec3 edge1 = mesh_.vertices[corners[1]] - origin;
    const Vec3 edge2 = mesh_.vertices[corners[2]] - origin;
    return edge1.cross(edge2).normalized();
}

}  // namespace bspline_curve
