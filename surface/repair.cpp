// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/repair.h"

#include "surface/mesh_checks.h"
#include "surface/repair_steps.h"
#include "text/error_messages.h"

#include <Eigen/Geometry>

#include <numeric>

namespace bspline_curve {

bool RepairReport::isEmpty() const {
    return count() == 0;
}

int RepairReport::count() const {
    return static_cast<int>(
        leftOutFaces.size() + mergedVertices.size() + removedDegenerateFaces.size() +
        splitFaces.size() + removedDuplicateFaces.size() + reversedFaces.size() + cutEdges.size() +
        joinedEdges.size() + joinedVertices.size() + duplicatedVertices.size()
    );
}

std::string RepairReport::summary() const {
    std::string text;
    const auto add = [&](std::size_t count, const char* one, const char* many) {
        if (count > 0) {
            text += (text.empty() ? "" : ", ") + describeCount(count, one, many);
        }
    };
    add(leftOutFaces.size(),
        "face with a coordinate that is not finite left out",
        "faces with a coordinate that is not finite left out");
    add(mergedVertices.size(), "vertex merged", "vertices merged");
    add(removedDegenerateFaces.size(), "face without area removed", "faces without area removed");
    add(splitFaces.size(), "face beside them split", "faces beside them split");
    add(removedDuplicateFaces.size(), "duplicate face removed", "duplicate faces removed");
    add(reversedFaces.size(), "face turned over", "faces turned over");
    add(cutEdges.size(), "edge cut", "edges cut");
    add(duplicatedVertices.size(), "vertex duplicated", "vertices duplicated");
    add(joinedEdges.size(),
        "pair of edges on each other joined",
        "pairs of edges on each other joined");
    return text;
}

std::vector<int> MeshRepair::vertexRoots() const {
    std::vector<int> roots = vertexOrigins;
    if (!seamRoots.empty()) {
        for (int& root : roots) {
            root = seamRoots[root];
        }
    }
    return roots;
}

SurfacePoint MeshRepair::toOrigin(const SurfacePoint& point) const {
    const auto found = changedCorners.find(point.face);
    return {
        .face = faceOrigins[point.face],
        .barycentric = found == changedCorners.end() ? point.barycentric
                                                     : Vec3(found->second * point.barycentric)
    };
}

namespace {

double diagonalOf(const TriangleMesh& mesh) {
    Eigen::AlignedBox3d box;
    for (const Triangle& face : mesh.faces) {
        for (const int v : face) {
            box.extend(mesh.vertices[v]);
        }
    }
    return box.diagonal().norm();
}

}  // namespace

MeshRepair repairMesh(TriangleMesh mesh, double weld, bool slits) {
    MeshRepair repair;
    repair.mesh = std::move(mesh);
    repair.vertexOrigins.resize(repair.mesh.vertices.size());
    std::iota(repair.vertexOrigins.begin(), repair.vertexOrigins.end(), 0);
    repair.faceOrigins.resize(repair.mesh.faces.size());
    std::iota(repair.faceOrigins.begin(), repair.faceOrigins.end(), 0);

    repair_steps::leaveOutFaces(repair);
    checkArrays(repair.mesh);
    if (weld > 0.0) {
        repair_steps::weldVertices(repair, weld * diagonalOf(repair.mesh));
    }
    repair_steps::removeDegenerateFaces(repair);
    repair_steps::removeDuplicateFaces(repair);
    repair_steps::Joints joints = repair_steps::joinAndOrient(
        repair, {}, slits ? std::vector<Seam>() : findSeams(repair.mesh)
    );
    repair_steps::splitVertices(repair, std::move(joints), repair_steps::Crowded::CutOut);
    return repair;
}

}  // namespace bspline_curve
