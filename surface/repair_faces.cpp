// SPDX-License-Identifier: GPL-3.0-or-later
// Faces without area and faces that are there twice.
#include "surface/half_edges.h"
#include "surface/mesh_checks.h"
#include "surface/near_vertices.h"
#include "surface/repair_steps.h"
#include "utility/disjoint_sets.h"
#include "utility/index_sets.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
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
    auto next = repair.changedCorners.begin();
    int kept = 0;
    for (int f = 0; f < static_cast<int>(repair.mesh.faces.size()); ++f) {
        const bool isChanged = next != repair.changedCorners.end() && next->first == f;
        if (isErased[f] == 0) {
            repair.mesh.faces[kept] = repair.mesh.faces[f];
            repair.faceOrigins[kept] = repair.faceOrigins[f];
            if (isChanged) {
                changed.emplace_hint(changed.end(), kept, next->second);
            }
            ++kept;
        }
        next = isChanged ? std::next(next) : next;
    }
    repair.mesh.faces.resize(kept);
    repair.faceOrigins.resize(kept);
    repair.changedCorners = std::move(changed);
}

using Edge = std::pair<int, int>;  // its vertices, the lower first

/// How many faces are at each edge, and which, while faces come and go.
class EdgeSides {
public:
    explicit EdgeSides(const std::vector<HalfEdge>& sorted) {
        forEachEdge(sorted, [&](std::span<const HalfEdge> edge) {
            edges_.emplace_back(edge[0].low, edge[0].high);
            sides_.emplace_back();
            for (const HalfEdge& side : edge) {
                sides_.back().add(side.face, side.k, 1);
            }
        });
    }

    struct Sides {
        int count = 0;
        std::int64_t sum = 0;  ///< of the half-edges, 3 * face + k

        void add(int face, int k, int sign) {
            count += sign;
            sum += sign * (std::int64_t{3} * face + k);
        }
    };

    [[nodiscard]] Sides& at(const Edge& edge) {
        const auto found = std::ranges::lower_bound(edges_, edge);
        return found != edges_.end() && *found == edge ? sides_[found - edges_.begin()]
                                                       : new_[edge];
    }

private:
    std::vector<Edge> edges_;  // ascending
    std::vector<Sides> sides_;
    std::map<Edge, Sides> new_;
};

/// Takes faces without area away. Short edges are merged first. Then faces across long edges are
/// split in rounds: each face is part of one split in a round, and what a face waits for decides
/// when it is looked at again, so that long rows of faces cost no more than others.
class DegenerateRemoval {
public:
    explicit DegenerateRemoval(MeshRepair& repair)
        : repair_(repair), mesh_(repair.mesh), isErased_(mesh_.faces.size(), 0) {}

    void run() {
        flat_ = indicesWhere<int>(mesh_.faces.size(), [&](std::size_t f) { return isFlat(f); });
        mergeShortEdges();
        if (!flat_.empty()) {
            splitAcrossLongEdges();
        }
        if (!repair_.report.removedDegenerateFaces.empty()) {
            eraseFaces(repair_, isErased_);
        }
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

    [[nodiscard]] bool isFlat(std::size_t face) const {
        return isErased_[face] == 0 && !hasArea(mesh_.faces[face]);
    }

    /// Those of the faces that are flat still, ascending.
    [[nodiscard]] std::vector<int> stillFlat(std::vector<int> faces) const {
        std::erase_if(faces, [&](int f) { return !isFlat(f); });
        sortUnique(faces);
        return faces;
    }

    void erase(int face) {
        isErased_[face] = 1;
        repair_.report.removedDegenerateFaces.push_back(repair_.faceOrigins[face]);
    }

    [[nodiscard]] bool isShort(int face, int k) const {
        const double size = std::max(
            corner(face, k + 1).lpNorm<Eigen::Infinity>(),
            corner(face, k + 2).lpNorm<Eigen::Infinity>()
        );
        return sideLength(face, k) <= 2.0 * kRelativeArea * size;
    }

    /// Merges the ends of edges that are no longer than rounding, until there are none at flat
    /// faces; every face on them goes.
    void mergeShortEdges() {
        DisjointSets merged(mesh_.vertices.size());
        for (bool hasMerged = true; hasMerged && !flat_.empty();) {
            hasMerged = false;
            for (const int f : flat_) {
                for (int k = 0; k < 3; ++k) {
                    if (isShort(f, k)) {
                        merged.unite(mesh_.faces[f][(k + 1) % 3], mesh_.faces[f][(k + 2) % 3]);
                        hasMerged = true;
                    }
                }
            }
            if (hasMerged) {
                takeMerged(merged);
            }
        }
        for (int v = 0; v < static_cast<int>(mesh_.vertices.size()); ++v) {
            if (merged.find(v) != v) {
                repair_.report.mergedVertices.emplace_back(v, merged.find(v));
            }
        }
    }

    void takeMerged(DisjointSets& merged) {
        for (int f = 0; f < static_cast<int>(mesh_.faces.size()); ++f) {
            if (isErased_[f] != 0) {
                continue;
            }
            const Triangle before = mesh_.faces[f];
            for (int& v : mesh_.faces[f]) {
                v = merged.find(v);
            }
            if (repeatsVertex(mesh_.faces[f])) {
                erase(f);
            } else if (mesh_.faces[f] != before) {
                flat_.push_back(f);
            }
        }
        flat_ = stillFlat(std::move(flat_));
    }

    [[nodiscard]] std::vector<HalfEdge> halfEdgesAtFlatFaces() const {
        std::vector<char> isAtFlat(mesh_.vertices.size(), 0);
        for (const int f : flat_) {
            for (const int v : mesh_.faces[f]) {
                isAtFlat[v] = 1;
            }
        }
        std::vector<int> near = indicesWhere<int>(mesh_.faces.size(), [&](std::size_t f) {
            return isErased_[f] == 0 &&
                   std::ranges::any_of(mesh_.faces[f], [&](int v) { return isAtFlat[v] != 0; });
        });
        std::vector<Triangle> faces;
        for (const int f : near) {
            faces.push_back(mesh_.faces[f]);
        }
        std::vector<HalfEdge> halfEdges = sortedHalfEdges(faces);
        for (HalfEdge& halfEdge : halfEdges) {
            halfEdge.face = near[halfEdge.face];
        }
        return halfEdges;
    }

    /// Every face that is left has its vertex `top` on its longest side. What cannot be split away
    /// is removed all the same, when nothing else is left.
    void splitAcrossLongEdges() {
        sides_ = std::make_unique<EdgeSides>(halfEdgesAtFlatFaces());
        round_.assign(mesh_.faces.size(), 0);
        std::vector<int> tried = flat_;
        for (bool isLast = false; !tried.empty();) {
            ++thisRound_;
            newEdges_.clear();
            for (const int f : tried) {
                if (round_[f] != thisRound_) {
                    tryFace(f, isLast);
                }
            }
            takeChanges();
            tried = stillFlat(std::exchange(woken_, {}));
            isLast = tried.empty();
            if (isLast) {
                tried = flat_ = stillFlat(std::move(flat_));
            }
        }
    }

    [[nodiscard]] static Edge sideOf(const Triangle& face, int k) {
        return std::minmax(face[(k + 1) % 3], face[(k + 2) % 3]);
    }

    void tryFace(int f, bool isLast) {
        int top = 0;
        for (int k = 1; k < 3; ++k) {
            top = sideLength(f, k) > sideLength(f, top) ? k : top;
        }
        const Edge edge = sideOf(mesh_.faces[f], top);
        const EdgeSides::Sides sides = sides_->at(edge);
        const bool isSplit = sides.count == 2 && split(f, top, sides.sum - 3 * f - top);
        if (!isSplit && (sides.count == 1 || isLast)) {
            for (int k = 0; k < 3; ++k) {
                const auto [low, high] = sideOf(mesh_.faces[f], k);
                repair_.removedEdges.push_back({low, high});
            }
            change(f, {});
            erase(f);
        } else if (!isSplit) {
            waiting_.emplace(edge, f);
        }
    }

    /// Splits the face across the long side of a flat one at the vertex on that side; one half
    /// takes the place of the flat face. Returns whether that is possible now.
    bool split(int flat, int top, std::int64_t across) {
        const int other = static_cast<int>(across / 3);
        const int k = static_cast<int>(across % 3);
        const Triangle whole = mesh_.faces[other];
        const int c = mesh_.faces[flat][top];
        const int s = whole[(k + 1) % 3];
        const int t = whole[(k + 2) % 3];
        const int d = whole[k];
        const Triangle first = {s, c, d};
        const Triangle second = {c, t, d};
        const Edge newEdge = std::minmax(c, d);
        if (round_[other] == thisRound_ || newEdges_.contains(newEdge)) {
            woken_.push_back(flat);
            return false;
        }
        if (c == d || !hasArea(first) || !hasArea(second)) {
            return false;
        }
        if (sides_->at(newEdge).count > 0) {
            waiting_.emplace(newEdge, flat);
            return false;
        }
        newEdges_.insert(newEdge);
        repair_.report.removedDegenerateFaces.push_back(repair_.faceOrigins[flat]);
        repair_.report.splitFaces.push_back(repair_.faceOrigins[other]);
        // Where the corners of both halves lie in the origin of the whole.
        const Eigen::Matrix3d corners =
            repair_.changedCorners.try_emplace(other, Eigen::Matrix3d::Identity()).first->second;
        const Vec3 inS = corners.col((k + 1) % 3);
        const Vec3 inT = corners.col((k + 2) % 3);
        const Vec3 along = mesh_.vertices[t] - mesh_.vertices[s];
        const double share = std::clamp(
            (mesh_.vertices[c] - mesh_.vertices[s]).dot(along) / along.squaredNorm(), 0.0, 1.0
        );
        const Vec3 inC = (1.0 - share) * inS + share * inT;
        repair_.changedCorners[other] << inS, inC, corners.col(k);
        repair_.changedCorners[flat] << inC, inT, corners.col(k);
        repair_.faceOrigins[flat] = repair_.faceOrigins[other];
        change(other, first);
        change(flat, second);
        return true;
    }

    /// Edges see it after the round. `into`: nothing where the face is erased.
    void change(int face, const std::optional<Triangle>& into) {
        round_[face] = thisRound_;
        const Triangle from = mesh_.faces[face];
        mesh_.faces[face] = into.value_or(from);
        changes_.push_back({face, from, mesh_.faces[face], !into});
    }

    /// Brings the edges up to date and wakes what waited for them.
    void takeChanges() {
        for (const Change& one : changes_) {
            for (int k = 0; k < 3; ++k) {
                sides_->at(sideOf(one.from, k)).add(one.face, k, -1);
                if (!one.isErased) {
                    sides_->at(sideOf(one.into, k)).add(one.face, k, 1);
                }
            }
        }
        for (const Change& one : changes_) {
            for (int k = 0; k < 3; ++k) {
                wakeAt(sideOf(one.from, k));
            }
        }
        changes_.clear();
    }

    void wakeAt(const Edge& edge) {
        if (sides_->at(edge).count > 2) {
            return;
        }
        const auto [begin, end] = waiting_.equal_range(edge);
        for (auto at = begin; at != end; ++at) {
            woken_.push_back(at->second);
        }
        waiting_.erase(begin, end);
    }

    MeshRepair& repair_;
    TriangleMesh& mesh_;
    std::vector<int> flat_;
    std::vector<char> isErased_;
    std::unique_ptr<EdgeSides> sides_;  // near the flat faces, before this round

    struct Change {
        int face;
        Triangle from, into;
        bool isErased;
    };

    int thisRound_ = 0;
    std::vector<int> round_;  // the last one that has changed a face
    std::vector<Change> changes_;
    std::set<Edge> newEdges_;
    std::multimap<Edge, int> waiting_;  // flat faces, by edges that would have to change
    std::vector<int> woken_;
};

}  // namespace

void leaveOutFaces(MeshRepair& repair) {
    const TriangleMesh& mesh = repair.mesh;
    const auto isNowhere = [&](int v) {
        return v >= 0 && v < std::ssize(mesh.vertices) && !isUsable(mesh.vertices[v]);
    };
    std::vector<char> isLeftOut(mesh.faces.size(), 0);
    std::vector<int>& leftOut = repair.report.leftOutFaces;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        if (std::ranges::any_of(mesh.faces[f], isNowhere)) {
            isLeftOut[f] = 1;
            leftOut.push_back(static_cast<int>(f));
        }
    }
    if (leftOut.size() == mesh.faces.size()) {
        leftOut.clear();
    } else if (!leftOut.empty()) {
        eraseFaces(repair, isLeftOut);
    }
}

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
    DegenerateRemoval(repair).run();
    std::ranges::sort(repair.report.removedDegenerateFaces);
    std::ranges::sort(repair.report.mergedVertices);
    sortUnique(repair.report.splitFaces);
    sortUnique(repair.removedEdges);
}

int divideFace(MeshRepair& repair, int face, int k, int vertex, double share) {
    const int from = (k + 1) % 3;
    const int to = (k + 2) % 3;
    const auto part = static_cast<int>(repair.mesh.faces.size());
    const Triangle whole = repair.mesh.faces[face];
    repair.mesh.faces.push_back(whole);
    repair.mesh.faces[face][to] = repair.mesh.faces[part][from] = vertex;
    repair.faceOrigins.push_back(repair.faceOrigins[face]);
    Eigen::Matrix3d& first =
        repair.changedCorners.try_emplace(face, Eigen::Matrix3d::Identity()).first->second;
    Eigen::Matrix3d& second = repair.changedCorners.try_emplace(part, first).first->second;
    const Vec3 middle = (1.0 - share) * first.col(from) + share * first.col(to);
    first.col(to) = second.col(from) = middle;
    return part;
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
    if (!repair.report.removedDuplicateFaces.empty()) {
        std::ranges::sort(repair.report.removedDuplicateFaces);
        eraseFaces(repair, isErased);
    }
}

}  // namespace bspline_curve::repair_steps
