// SPDX-License-Identifier: GPL-3.0-or-later
// Faces without area and faces that are there twice.
#include "surface/half_edges.h"
#include "surface/mesh_checks.h"
#include "surface/near_vertices.h"
#include "surface/repair_steps.h"
#include "utility/disjoint_sets.h"
#include "utility/index_sets.h"

#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <utility>

namespace bspline_curve::repair_steps {

namespace {

bool repeatsVertex(const Triangle& face) {
    return face[0] == face[1] || face[1] == face[2] || face[2] == face[0];
}

/// Takes faces out of the mesh; the others keep their order.
void eraseFaces(MeshRepair& repair, const std::vector<char>& isErased) {
    std::map<int, Eigen::Matrix3d> changed;
    int kept = 0;
    for (int f = 0; f < static_cast<int>(repair.mesh.faces.size()); ++f) {
        if (isErased[f] != 0) {
            continue;
        }
        repair.mesh.faces[kept] = repair.mesh.faces[f];
        repair.faceOrigins[kept] = repair.faceOrigins[f];
        if (const auto found = repair.changedCorners.find(f);
            found != repair.changedCorners.end()) {
            changed[kept] = found->second;
        }
        ++kept;
    }
    repair.mesh.faces.resize(kept);
    repair.faceOrigins.resize(kept);
    repair.changedCorners = std::move(changed);
}

/// One round over the faces without area that are there. A split can be in the way of another one,
/// which then waits for the next round.
class DegenerateRound {
public:
    explicit DegenerateRound(MeshRepair& repair) : repair_(repair), mesh_(repair.mesh) {
        isErased_.assign(mesh_.faces.size(), 0);
        isTouched_.assign(mesh_.faces.size(), 0);
        for (int f = 0; f < static_cast<int>(mesh_.faces.size()); ++f) {
            if (!hasArea(mesh_.faces[f])) {
                flat_.push_back(f);
            }
        }
    }

    [[nodiscard]] bool hasWork() const { return !flat_.empty(); }

    /// `last`: what cannot be split away is removed all the same. Returns whether anything changed.
    bool run(bool last) {
        if (!mergeShortEdges()) {
            splitAcrossLongEdges(last);
        }
        eraseFaces(repair_, isErased_);
        return hasChanged_;
    }

private:
    [[nodiscard]] const Vec3& corner(int face, int k) const {
        return mesh_.vertices[mesh_.faces[face][k % 3]];
    }

    [[nodiscard]] double sideLength(int face, int k) const {
        return (corner(face, k + 1) - corner(face, k + 2)).norm();
    }

    [[nodiscard]] bool hasArea(const Triangle& face) const {
        return bspline_curve::hasArea(
            mesh_.vertices[face[0]], mesh_.vertices[face[1]], mesh_.vertices[face[2]]
        );
    }

    void erase(int face) {
        isErased_[face] = 1;
        hasChanged_ = true;
        repair_.report.removedDegenerateFaces.push_back(repair_.faceOrigins[face]);
    }

    /// Merges the ends of edges that are no longer than rounding; every face on them goes. Returns
    /// whether there was any such face.
    bool mergeShortEdges() {
        DisjointSets merged(mesh_.vertices.size());
        for (const int f : flat_) {
            for (int k = 0; k < 3; ++k) {
                const double size = std::max(
                    corner(f, k + 1).lpNorm<Eigen::Infinity>(),
                    corner(f, k + 2).lpNorm<Eigen::Infinity>()
                );
                if (sideLength(f, k) <= 2.0 * kRelativeArea * size) {
                    merged.unite(mesh_.faces[f][(k + 1) % 3], mesh_.faces[f][(k + 2) % 3]);
                }
            }
        }
        bool hasMerged = false;
        for (int f = 0; f < static_cast<int>(mesh_.faces.size()); ++f) {
            for (int& v : mesh_.faces[f]) {
                v = merged.find(v);
            }
            if (repeatsVertex(mesh_.faces[f])) {
                erase(f);
                hasMerged = true;
            }
        }
        for (int v = 0; v < static_cast<int>(mesh_.vertices.size()); ++v) {
            if (merged.find(v) != v) {
                repair_.report.mergedVertices.emplace_back(v, merged.find(v));
            }
        }
        return hasMerged;
    }

    /// Every face that is left has its vertex `top` on its longest side.
    void splitAcrossLongEdges(bool last) {
        halfEdges_ = sortedHalfEdges(mesh_.faces);
        for (const int f : flat_) {
            if (isTouched_[f] != 0) {
                continue;
            }
            int top = 0;
            for (int k = 1; k < 3; ++k) {
                top = sideLength(f, k) > sideLength(f, top) ? k : top;
            }
            const std::span<const HalfEdge> edge =
                halfEdgesBetween(mesh_.faces[f][(top + 1) % 3], mesh_.faces[f][(top + 2) % 3]);
            const bool isAtBoundary = edge.size() == 1;
            const bool isSplit = edge.size() == 2 && split(f, top, edge[edge[0].face == f ? 1 : 0]);
            if (!isSplit && (isAtBoundary || last)) {
                isTouched_[f] = 1;
                erase(f);
            }
        }
    }

    [[nodiscard]] std::span<const HalfEdge> halfEdgesBetween(int a, int b) const {
        const std::pair<int, int> edge = std::minmax(a, b);
        const auto ends = [](const HalfEdge& h) { return std::pair(h.low, h.high); };
        return std::ranges::equal_range(halfEdges_, edge, {}, ends);
    }

    /// Splits the face across the long side of a flat one at the vertex on that side; one half
    /// takes the place of the flat face. Returns whether that is possible now.
    bool split(int flat, int top, const HalfEdge& across) {
        const int other = across.face;
        const Triangle whole = mesh_.faces[other];
        const int c = mesh_.faces[flat][top];
        const int s = whole[(across.k + 1) % 3];
        const int t = whole[(across.k + 2) % 3];
        const int d = whole[across.k];
        const Triangle first = {s, c, d};
        const Triangle second = {c, t, d};
        const std::pair<int, int> newEdge = std::minmax(c, d);
        const bool isFree = isTouched_[other] == 0 && c != d && !newEdges_.contains(newEdge) &&
                            halfEdgesBetween(c, d).empty();
        if (!isFree || !hasArea(first) || !hasArea(second)) {
            return false;
        }
        newEdges_.insert(newEdge);
        isTouched_[flat] = isTouched_[other] = 1;
        hasChanged_ = true;
        repair_.report.removedDegenerateFaces.push_back(repair_.faceOrigins[flat]);
        repair_.report.splitFaces.push_back(repair_.faceOrigins[other]);
        // Where the corners of both halves lie in the origin of the whole.
        const Eigen::Matrix3d corners =
            repair_.changedCorners.try_emplace(other, Eigen::Matrix3d::Identity()).first->second;
        const Vec3 inS = corners.col((across.k + 1) % 3);
        const Vec3 inT = corners.col((across.k + 2) % 3);
        const Vec3 along = mesh_.vertices[t] - mesh_.vertices[s];
        const double share = std::clamp(
            (mesh_.vertices[c] - mesh_.vertices[s]).dot(along) / along.squaredNorm(), 0.0, 1.0
        );
        const Vec3 inC = (1.0 - share) * inS + share * inT;
        repair_.changedCorners[other] << inS, inC, corners.col(across.k);
        repair_.changedCorners[flat] << inC, inT, corners.col(across.k);
        repair_.faceOrigins[flat] = repair_.faceOrigins[other];
        mesh_.faces[other] = first;
        mesh_.faces[flat] = second;
        return true;
    }

    MeshRepair& repair_;
    TriangleMesh& mesh_;
    std::vector<int> flat_;
    std::vector<char> isErased_, isTouched_;
    std::vector<HalfEdge> halfEdges_;
    std::set<std::pair<int, int>> newEdges_;
    bool hasChanged_ = false;
};

}  // namespace

void weldVertices(MeshRepair& repair, double distance) {
    DisjointSets near = nearVertices(repair.mesh.vertices, distance);
    std::vector<int> merged;
    for (Triangle& face : repair.mesh.faces) {
        for (int& v : face) {
            const int into = near.find(v);
            if (into != v) {
                merged.push_back(v);
                v = into;
            }
        }
    }
    sortUnique(merged);
    for (const int v : merged) {
        repair.report.mergedVertices.emplace_back(v, near.find(v));
    }
}

void removeDegenerateFaces(MeshRepair& repair) {
    for (bool last = false;;) {
        DegenerateRound round(repair);
        if (!round.hasWork()) {
            break;
        }
        last = !round.run(last);
    }
    std::ranges::sort(repair.report.removedDegenerateFaces);
    std::ranges::sort(repair.report.mergedVertices);
    sortUnique(repair.report.splitFaces);
}

void removeDuplicateFaces(MeshRepair& repair) {
    std::vector<std::pair<Triangle, int>> entries;  // by corners, ascending
    for (int f = 0; f < static_cast<int>(repair.mesh.faces.size()); ++f) {
        entries.emplace_back(repair.mesh.faces[f], f);
        std::ranges::sort(entries.back().first);
    }
    std::ranges::sort(entries);
    std::vector<char> isErased(entries.size(), 0);
    for (std::size_t i = 1; i < entries.size(); ++i) {
        const auto& [corners, face] = entries[i];
        if (corners == entries[i - 1].first) {
            isErased[face] = 1;
            repair.report.removedDuplicateFaces.push_back(repair.faceOrigins[face]);
        }
    }
    std::ranges::sort(repair.report.removedDuplicateFaces);
    eraseFaces(repair, isErased);
}

}  // namespace bspline_curve::repair_steps
