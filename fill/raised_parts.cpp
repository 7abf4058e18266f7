// SPDX-License-Identifier: GPL-3.0-or-later
#include "fill/raised_parts.h"

#include "bspline_curve/error.h"
#include "fill/crossing_finder.h"
#include "surface/mesh_checks.h"
#include "surface/vertex_normals.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>

namespace bspline_curve {

namespace {

Vec3 areaVector(const TriangleMesh& mesh, const Triangle& face) {
    const Vec3& corner = mesh.vertices[face[0]];
    return (mesh.vertices[face[1]] - corner).cross(mesh.vertices[face[2]] - corner);
}

/// Unit normals at the vertices of an imprint: those of the mesh without it, linear in each face,
/// so that they change little across small faces.
std::vector<Vec3> normalsOn(const ImprintedMesh& imprinted) {
    const TriangleMesh before = withoutImprint(imprinted);
    std::vector<Vec3> normals = vertexNormals(before);
    for (const auto& [face, barycentric] : imprinted.ownPlaces) {
        Vec3 normal = Vec3::Zero();
        for (int k = 0; k < 3; ++k) {
            normal += barycentric[k] * normals[before.faces[face][k]];
        }
        normals.push_back(normal.stableNormalized());
    }
    return normals;
}

class PartRaiser {
public:
    PartRaiser(
        const ImprintedMesh& imprinted,
        const MeshParts& parts,
        const std::vector<int>& chosen,
        double height,
        const std::vector<double>& shares
    )
        : imprinted_(imprinted), parts_(parts), chosen_(chosen), height_(height), shares_(shares) {
        edges_ = edgesAround(imprinted, parts, chosen);
        cut_ = cutAlongEdges(imprinted.mesh, edges_);
        result_.whole = wholeImprint(imprinted, parts);
        raised_.resize(cut_.mesh.vertices.size(), -1);
    }

    RaisedParts run() {
        findBase();
        const std::vector<Vec3> normals = normalsOn(imprinted_);
        for (std::size_t f = 0; f < parts_.labels.size(); ++f) {
            if (isChosen(f)) {
                raise(f, normals);
            }
        }
        if (shares_.empty()) {
            addWalls();
        }
        result_.whole.crossing = crossingFaces();
        return std::move(result_);
    }

private:
    [[nodiscard]] bool isChosen(std::size_t face) const {
        return std::ranges::binary_search(chosen_, parts_.labels[face]);
    }

    /// Vertices of faces that stay where they are, and those of these that walls stand on.
    void findBase() {
        isBase_.resize(imprinted_.mesh.vertices.size(), false);
        for (std::size_t f = 0; f < parts_.labels.size(); ++f) {
            if (!isChosen(f)) {
                const Triangle& face = imprinted_.mesh.faces[f];
                for (std::size_t k = 0; k < 3; ++k) {
                    isBase_[face[k]] = true;
                    const auto [low, high] = std::minmax(face[k], face[(k + 1) % 3]);
                    if (std::ranges::binary_search(edges_, std::array{low, high})) {
                        below_[{low, high}] = static_cast<int>(f);
                    }
                }
            }
        }
    }

    void raise(std::size_t face, const std::vector<Vec3>& normals) {
        TriangleMesh& mesh = result_.whole.mesh;
        for (std::size_t k = 0; k < 3; ++k) {
            int& raised = raised_[cut_.mesh.faces[face][k]];
            if (raised < 0) {
                const int vertex = imprinted_.mesh.faces[face][k];
                raised = vertex;
                if (isBase_[vertex] && !shares_.empty()) {
                    continue;
                }
                if (isBase_[vertex]) {
                    raised = static_cast<int>(mesh.vertices.size());
                    mesh.vertices.push_back(mesh.vertices[vertex]);
                    result_.whole.source.push_back(vertex);
                }
                mesh.vertices[raised] +=
                    (shares_.empty() ? height_ : height_ * shares_[vertex]) * normals[vertex];
            }
            mesh.faces[face][k] = raised;
        }
        result_.turnedFaces += shares_.empty() && isTurned(face) ? 1 : 0;
    }

    /// Past one centre of curvature a face is turned over; past both, its sides point back.
    [[nodiscard]] bool isTurned(std::size_t face) const {
        const TriangleMesh& before = imprinted_.mesh;
        const TriangleMesh& after = result_.whole.mesh;
        const Triangle& from = before.faces[face];
        const Triangle& to = after.faces[face];
        bool turned = areaVector(before, from).dot(areaVector(after, to)) < 0.0;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t next = (k + 1) % 3;
            const Vec3 side = before.vertices[from[next]] - before.vertices[from[k]];
            turned |= side.dot(after.vertices[to[next]] - after.vertices[to[k]]) < 0.0;
        }
        return turned;
    }

    /// Between the edges of raised faces on the rim and those of the faces beside them.
    void addWalls() {
        FilledParts& whole = result_.whole;
        for (std::size_t f = 0; f < parts_.labels.size(); ++f) {
            if (!isChosen(f)) {
                continue;
            }
            const Triangle& foot = imprinted_.mesh.faces[f];
            const Triangle top = whole.mesh.faces[f];
            for (std::size_t k = 0; k < 3; ++k) {
                const std::size_t next = (k + 1) % 3;
                const auto [low, high] = std::minmax(foot[k], foot[next]);
                if (std::ranges::binary_search(edges_, std::array{low, high})) {
                    whole.mesh.faces.push_back({foot[k], foot[next], top[next]});
                    whole.mesh.faces.push_back({foot[k], top[next], top[k]});
                    const int above = static_cast<int>(f);
                    const int below = below_.at({low, high});
                    whole.walls.push_back({below, below, above});
                    whole.walls.push_back({below, above, above});
                }
            }
        }
        whole.faces.resize(whole.mesh.faces.size(), -1);
        whole.labels.resize(whole.mesh.faces.size(), -1);
    }

    /// Of those that were moved and the walls.
    [[nodiscard]] std::vector<int> crossingFaces() const {
        const TriangleMesh& mesh = result_.whole.mesh;
        std::vector<Triangle> kept;
        std::vector<Triangle> moved;
        std::vector<int> ids;
        std::vector<int> crossing;
        for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
            const auto& [a, b, c] = mesh.faces[f];
            if (f < parts_.labels.size() && !isChosen(f)) {
                kept.push_back(mesh.faces[f]);
            } else if (hasArea(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c])) {
                moved.push_back(mesh.faces[f]);
                ids.push_back(static_cast<int>(f));
            } else {
                crossing.push_back(static_cast<int>(f));
            }
        }
        CrossingFinder finder(mesh.vertices, kept, false);
        for (const int i : finder.crossingsOf(moved).faces()) {
            crossing.push_back(ids[i]);
        }
        std::ranges::sort(crossing);
        return crossing;
    }

    const ImprintedMesh& imprinted_;
    const MeshParts& parts_;
    const std::vector<int>& chosen_;
    double height_;
    const std::vector<double>& shares_;
    std::vector<std::array<int, 2>> edges_;    // of curves around the parts
    CutMesh cut_;                              // parts it into fans of raised faces and of others
    std::vector<bool> isBase_;                 // for each imprinted vertex
    std::map<std::array<int, 2>, int> below_;  // by edges around the parts: faces that stay
    std::vector<int> raised_;                  // for each vertex of the cut; -1: not raised
    RaisedParts result_;
};

}  // namespace

RaisedParts raisedParts(
    const ImprintedMesh& imprinted,
    const MeshParts& parts,
    const std::vector<int>& chosen,
    double height,
    const std::vector<double>& shares
) {
    if (!std::isfinite(height)) {
        throw InputError(InputErrorCode::BadOption, "the height of a relief must be finite");
    }
    if (height == 0.0) {
        return {.whole = wholeImprint(imprinted, parts), .turnedFaces = 0};
    }
    return PartRaiser(imprinted, parts, chosen, height, shares).run();
}

}  // namespace bspline_curve
