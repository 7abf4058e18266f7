// SPDX-License-Identifier: GPL-3.0-or-later
#include "imprint/unjoined_imprint.h"

#include "surface/surface_point.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace bspline_curve {

namespace {

class Unjoiner {
public:
    Unjoiner(const Surface& surface, const ImprintedMesh& joined)
        : surface_(surface),
          provenance_(surface.provenance()),
          corners_(provenance_.inputCorners()),
          result_(joined),
          inputCount_(static_cast<int>(surface.input().vertices.size())),
          home_(joined.surfaceVertexCount, kNone),
          takenFor_(inputCount_, -1),
          copies_(joined.ownPlaces.size(), Copy{}) {}

    [[nodiscard]] ImprintedMesh run() {
        findHomes();
        for (std::size_t i = 0; i < copies_.size(); ++i) {
            doubleOnSeam(i);
        }
        for (std::size_t f = 0; f < result_.mesh.faces.size(); ++f) {
            for (int& vertex : result_.mesh.faces[f]) {
                vertex = ofItsSide(vertex, result_.ownParents[f]);
            }
        }
        for (ImprintedCurve& curve : result_.curves) {
            for (int& vertex : curve.vertices) {
                vertex = atHome(vertex);
            }
        }
        for (int& vertex : result_.crossings) {
            vertex = atHome(vertex);
        }
        leaveOutUnused();
        std::ranges::sort(result_.crossings);
        return std::move(result_);
    }

private:
    static constexpr int kNone = -2;  // of vertices without faces; -1: the input has no such vertex

    /// Of a new vertex on a seam.
    struct Copy {
        int face = -1;  ///< of the surface, on the side that the copy is for; -1: there is none
        int vertex = -1;
    };

    /// What each vertex of the surface is in the input: itself, if any of its corners is that, else
    /// what its first corner is.
    void findHomes() {
        for (int f = 0; f < surface_.faceCount(); ++f) {
            for (std::size_t k = 0; k < 3; ++k) {
                const int vertex = surface_.faces()[f][k];
                if (home_[vertex] == kNone || corners_[f][k] == vertex) {
                    home_[vertex] = corners_[f][k];
                }
            }
        }
    }

    /// An edge of a face of the surface by its vertices in the input, ascending.
    [[nodiscard]] std::array<int, 2> inputEdge(int face, int a, int b) const {
        const Triangle& own = surface_.faces()[face];
        const auto [low, high] =
            std::minmax({corners_[face].at(cornerOf(own, a)), corners_[face].at(cornerOf(own, b))});
        return {low, high};
    }

    /// Doubles the new vertex `i` where it is on a seam.
    void doubleOnSeam(std::size_t i) {
        const auto [face, barycentric] = result_.ownPlaces[i];
        Eigen::Index k = 0;
        if (barycentric.minCoeff(&k) > kOnEdgeBarycentric) {
            return;
        }
        const int across = surface_.faceNeighbours()[face][k];
        if (across < 0) {
            return;
        }
        const Triangle& own = surface_.faces()[face];
        const int a = own[(k + 1) % 3];
        const int b = own[(k + 2) % 3];
        const std::array<int, 2> here = inputEdge(face, a, b);
        const std::array<int, 2> there = inputEdge(across, a, b);
        if (here == there) {
            return;
        }
        const auto [keeping, copying] =
            here < there ? std::pair(face, across) : std::pair(across, face);
        const int vertex = result_.surfaceVertexCount + static_cast<int>(i);
        const SurfacePoint kept = placeIn(i, keeping);
        const SurfacePoint copied = placeIn(i, copying);
        result_.ownPlaces[i] = kept;
        result_.newVertices[vertex - inputCount_] = provenance_.toInput(kept);
        copies_[i] = {copying, append(vertex, copied, -1)};
    }

    [[nodiscard]] SurfacePoint placeIn(std::size_t i, int face) const {
        return inFace(surface_, result_.ownPlaces[i], face);
    }

    int append(int vertex, const SurfacePoint& own, int doubled) {
        const Vec3 position = result_.mesh.vertices[vertex];
        result_.mesh.vertices.push_back(position);
        result_.ownPlaces.push_back(own);
        result_.newVertices.push_back(provenance_.toInput(own));
        result_.doubledVertices.push_back(doubled);
        return static_cast<int>(result_.mesh.vertices.size()) - 1;
    }

    /// The vertex that a face of the surface, or a part of it, has for one of the joined imprint.
    [[nodiscard]] int ofItsSide(int vertex, int face) {
        if (vertex >= result_.surfaceVertexCount) {
            const auto& [copying, copy] = copies_[vertex - result_.surfaceVertexCount];
            return copying == face ? copy : vertex;
        }
        const int k = cornerOf(surface_.faces()[face], vertex);
        const SurfacePoint corner{.face = face, .barycentric = Vec3::Unit(k)};
        return ofInput(vertex, corners_[face].at(k), corner);
    }

    /// A vertex of the surface as one of the input, at a corner where it is that.
    int ofInput(int vertex, int input, const SurfacePoint& corner) {
        if (input == vertex) {
            return vertex;
        }
        if (vertex >= inputCount_ && input == home_[vertex]) {
            result_.newVertices[vertex - inputCount_] = provenance_.toInput(corner);
            result_.doubledVertices[vertex - inputCount_] = input;
            return vertex;
        }
        const bool isFree = surface_.facesAround(input).empty();
        if (isFree && (takenFor_[input] < 0 || takenFor_[input] == vertex)) {
            takenFor_[input] = vertex;
            return input;
        }
        // Mending has parted faces here as well, and others of them have the vertex.
        const auto [copy, isNew] = doubled_.try_emplace({vertex, input}, -1);
        if (isNew) {
            copy->second = append(input, corner, input);
        }
        return copy->second;
    }

    /// Of the vertices that stand for one of the joined imprint the one that curves name.
    [[nodiscard]] int atHome(int vertex) {
        if (vertex >= result_.surfaceVertexCount || home_[vertex] == vertex) {
            return vertex;
        }
        for (const int face : surface_.facesAround(vertex)) {
            const int k = cornerOf(surface_.faces()[face], vertex);
            if (corners_[face].at(k) == home_[vertex]) {
                return ofItsSide(vertex, face);
            }
        }
        return vertex;
    }

    /// Where faces were joined anew, they have left copies behind.
    void leaveOutUnused() {
        const auto count = static_cast<int>(result_.mesh.vertices.size());
        std::vector<char> isKept(count, 0);
        std::fill_n(isKept.begin(), inputCount_, 1);
        for (const Triangle& face : result_.mesh.faces) {
            for (const int vertex : face) {
                isKept[vertex] = 1;
            }
        }
        std::vector<int> ids(count);
        std::exclusive_scan(isKept.begin(), isKept.end(), ids.begin(), 0);
        const auto keep = [&](auto& list, int first) {
            std::size_t kept = 0;
            for (std::size_t i = 0; i < list.size(); ++i) {
                if (isKept[first + i] != 0) {
                    list[kept++] = list[i];
                }
            }
            list.resize(kept);
        };
        keep(result_.mesh.vertices, 0);
        keep(result_.newVertices, inputCount_);
        keep(result_.doubledVertices, inputCount_);
        keep(result_.ownPlaces, result_.surfaceVertexCount);
        const auto ofSurface = std::span(isKept).first(result_.surfaceVertexCount);
        result_.surfaceVertexCount = static_cast<int>(std::ranges::count(ofSurface, 1));
        const auto renumber = [&](auto& list) {
            for (int& vertex : list) {
                vertex = ids[vertex];
            }
        };
        std::ranges::for_each(result_.mesh.faces, renumber);
        for (ImprintedCurve& curve : result_.curves) {
            renumber(curve.vertices);
        }
        renumber(result_.crossings);
    }

    const Surface& surface_;
    const Provenance& provenance_;
    std::span<const Triangle> corners_;
    ImprintedMesh result_;
    int inputCount_;
    std::vector<int> home_;                       // of the surface's vertices
    std::vector<int> takenFor_;                   // the input's vertices, by whom; -1: nobody
    std::vector<Copy> copies_;                    // of the joined imprint's new vertices
    std::map<std::pair<int, int>, int> doubled_;  // by vertices of the surface and the input
};

}  // namespace

ImprintedMesh unjoined(const Surface& surface, const ImprintedMesh& joined) {
    return surface.provenance().hasInputCorners() ? Unjoiner(surface, joined).run() : joined;
}

}  // namespace bspline_curve
