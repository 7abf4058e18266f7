// SPDX-License-Identifier: GPL-3.0-or-later
#include "fill/unjoined_parts.h"

#include "surface/surface_point.h"
#include "utility/index_sets.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace bspline_curve {

namespace {

/// A vertex of some parts as the faces on one side of a seam have it.
struct SideVertex {
    int vertex;
    int side;  ///< the vertex of the unjoined imprint that it is there; -1: it is new
    auto operator<=>(const SideVertex&) const = default;
};

class PartsUnjoiner {
public:
    PartsUnjoiner(
        const FilledParts& parts, const ImprintedMesh& joined, const ImprintedMesh& unjoined
    )
        : parts_(parts), joined_(joined), unjoined_(unjoined) {}

    [[nodiscard]] FilledParts run() {
        findFirst();
        findSides();
        numberVertices();
        FilledParts result = parts_;
        result.mesh = mesh();
        result.source.clear();
        for (const int i : order_) {
            result.source.push_back(sides_[i].side);
        }
        for (std::vector<int>& rim : result.rims) {
            for (int& vertex : rim) {
                vertex = ids_[firstSideOf(vertex)];
            }
        }
        const auto isFirst = [&](int i) { return isFirst_[sides_[i].vertex] != 0; };
        const auto moved = std::ranges::count_if(order_, isFirst) - std::ranges::count(isFirst_, 1);
        for (int& first : result.firstNew) {
            first += static_cast<int>(moved);
        }
        result.endOfNew += result.firstNew.empty() ? 0 : static_cast<int>(moved);
        return result;
    }

private:
    /// Whether a vertex is the first one of its source.
    void findFirst() {
        std::vector<char> isFound(joined_.mesh.vertices.size(), 0);
        for (const int source : parts_.source) {
            isFirst_.push_back(source >= 0 && isFound[source] == 0 ? 1 : 0);
            if (source >= 0) {
                isFound[source] = 1;
            }
        }
    }

    void findSides() {
        std::vector<char> isUsed(isFirst_.size(), 0);
        std::vector<char> isTaken(unjoined_.mesh.vertices.size(), 0);
        for (std::size_t f = 0; f < parts_.faces.size(); ++f) {
            for (int k = 0; parts_.faces[f] >= 0 && k < 3; ++k) {
                const SideVertex at{parts_.mesh.faces[f][k], unjoinedAt(parts_.faces[f], k)};
                sides_.push_back(at);
                isUsed[at.vertex] = 1;
                isTaken[at.side] = static_cast<char>(isTaken[at.side] | isFirst_[at.vertex]);
            }
        }
        for (std::size_t v = 0; v < isUsed.size(); ++v) {
            // A vertex that was joined to another one is there again by the faces of that.
            const int source = parts_.source[v];
            if (isUsed[v] == 0 && (source < 0 || isTaken[source] == 0)) {
                sides_.push_back({static_cast<int>(v), source});
            }
        }
        sortUnique(sides_);
    }

    void numberVertices() {
        order_.resize(sides_.size());
        std::iota(order_.begin(), order_.end(), 0);
        std::ranges::sort(order_, {}, [&](int i) {
            const auto [vertex, side] = sides_[i];
            return isFirst_[vertex] != 0 ? std::tuple(0, side, i) : std::tuple(1, 0, i);
        });
        ids_.resize(order_.size());
        for (std::size_t id = 0; id < order_.size(); ++id) {
            ids_[order_[id]] = static_cast<int>(id);
        }
    }

    [[nodiscard]] TriangleMesh mesh() const {
        TriangleMesh mesh;
        for (const int i : order_) {
            const auto [vertex, side] = sides_[i];
            // Zeros of either sign are one place.
            const Vec3& place = parts_.mesh.vertices[vertex];
            const bool isMoved = side < 0 || unjoined_.mesh.vertices[side] != place;
            mesh.vertices.push_back(isMoved ? place : unjoined_.mesh.vertices[side]);
        }
        for (std::size_t f = 0; f < parts_.faces.size(); ++f) {
            Triangle& face = mesh.faces.emplace_back();
            for (int k = 0; k < 3; ++k) {
                face[k] = ids_[sideAt(static_cast<int>(f), k)];
            }
        }
        return mesh;
    }

    [[nodiscard]] int unjoinedAt(int imprintedFace, int k) const {
        return unjoined_.mesh.faces[imprintedFace].at(k);
    }

    /// Of `sides_`, the first one of a vertex.
    [[nodiscard]] std::size_t firstSideOf(int vertex) const {
        const auto found = std::ranges::lower_bound(sides_, vertex, {}, &SideVertex::vertex);
        return static_cast<std::size_t>(found - sides_.begin());
    }

    /// Of `sides_`, that of a corner of a face.
    [[nodiscard]] std::size_t sideAt(int face, int k) const {
        const int vertex = parts_.mesh.faces[face][k];
        if (parts_.faces[face] >= 0) {
            return sideOf({vertex, unjoinedAt(parts_.faces[face], k)});
        }
        const int beside = besideWall(face, k);
        if (beside < 0) {
            return firstSideOf(vertex);
        }
        const int there = cornerOf(joined_.mesh.faces[beside], parts_.source[vertex]);
        return sideOf({vertex, unjoinedAt(beside, there)});
    }

    [[nodiscard]] std::size_t sideOf(const SideVertex& wanted) const {
        return static_cast<std::size_t>(std::ranges::lower_bound(sides_, wanted) - sides_.begin());
    }

    /// The face of the imprint that a corner of a wall is on; -1: the face is no wall.
    [[nodiscard]] int besideWall(int face, int k) const {
        const auto firstWall = static_cast<int>(parts_.faces.size() - parts_.walls.size());
        return face < firstWall ? -1 : parts_.walls[face - firstWall][k];
    }

    const FilledParts& parts_;
    const ImprintedMesh& joined_;
    const ImprintedMesh& unjoined_;
    std::vector<char> isFirst_;
    std::vector<SideVertex> sides_;  // ascending
    std::vector<int> order_;         // of `sides_`, in that of the result's vertices
    std::vector<int> ids_;           // of `sides_`: the result's vertex
};

}  // namespace

FilledParts unjoined(
    const FilledParts& parts, const ImprintedMesh& joined, const ImprintedMesh& unjoined
) {
    return PartsUnjoiner(parts, joined, unjoined).run();
}

}  // namespace bspline_curve
