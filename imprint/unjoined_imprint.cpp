// SPDX-License-Identifier: GPL-3.0-or-later
#include "imprint/unjoined_imprint.h"

#include "surface/surface_point.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <span>
#include <utility>

namespace bspline_curve {

namespace {

class Unjoiner {
public:
    Unjoiner(const Surface& surface, const ImprintedMesh& joined)
        : surface_(surface),
          provenance_(surface.provenance()),
          unjoinedFaces_(provenance_.unjoinedFaces()),
          result_(joined),
          inputCount_(joined.mesh.vertices.size() - joined.newVertices.size()),
          joinedInto_(inputCount_, -1),
          copies_(joined.ownPlaces.size(), Copy{}) {
        for (const auto& [vertex, into] : provenance_.report()->joinedVertices) {
            joinedInto_[vertex] = into;
        }
    }

    ImprintedMesh run() {
        for (std::size_t i = 0; i < copies_.size(); ++i) {
            doubleOnSeam(i);
        }
        for (std::size_t f = 0; f < result_.mesh.faces.size(); ++f) {
            for (int& vertex : result_.mesh.faces[f]) {
                vertex = ofItsSide(vertex, result_.ownParents[f]);
            }
        }
        return std::move(result_);
    }

private:
    /// Of a new vertex on a seam.
    struct Copy {
        int face = -1;  ///< of the surface, on the side that the copy is for; -1: there is none
        int vertex = -1;
    };

    /// An edge of a face of the surface by its vertices before seams were joined, ascending.
    [[nodiscard]] std::array<int, 2> unjoinedEdge(int face, int a, int b) const {
        const Triangle& corners = surface_.faces()[face];
        const auto [low, high] = std::minmax(
            {unjoinedFaces_[face].at(cornerOf(corners, a)),
             unjoinedFaces_[face].at(cornerOf(corners, b))}
        );
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
        const Triangle& corners = surface_.faces()[face];
        const int a = corners[(k + 1) % 3];
        const int b = corners[(k + 2) % 3];
        const std::array<int, 2> here = unjoinedEdge(face, a, b);
        const std::array<int, 2> there = unjoinedEdge(across, a, b);
        if (here == there) {
            return;
        }
        const auto [keeping, copying] =
            here < there ? std::pair(face, across) : std::pair(across, face);
        const int vertex = result_.surfaceVertexCount + static_cast<int>(i);
        setPlace(vertex, placeIn(i, keeping));
        copies_[i] = {copying, append(vertex, placeIn(i, copying), -1)};
    }

    [[nodiscard]] SurfacePoint placeIn(std::size_t i, int face) const {
        return inFace(surface_, result_.ownPlaces[i], face);
    }

    void setPlace(int vertex, const SurfacePoint& own) {
        result_.newVertices[vertex - inputCount_] = provenance_.toInput(own);
        if (vertex >= result_.surfaceVertexCount) {
            result_.ownPlaces[vertex - result_.surfaceVertexCount] = own;
        }
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
        const int input = unjoinedFaces_[face].at(k);
        const SurfacePoint corner{.face = face, .barycentric = Vec3::Unit(k)};
        if (input == provenance_.inputVertex(vertex)) {
            if (vertex >= static_cast<int>(inputCount_)) {
                setPlace(vertex, corner);
            }
            return vertex;
        }
        if (joinedInto_[input] == vertex) {
            return input;
        }
        // Mending has parted faces here as well, and others of them have the vertex.
        const auto [copy, isNew] = doubled_.try_emplace({vertex, input}, -1);
        if (isNew) {
            copy->second = append(input, corner, input);
        }
        return copy->second;
    }

    const Surface& surface_;
    const Provenance& provenance_;
    std::span<const Triangle> unjoinedFaces_;
    ImprintedMesh result_;
    std::size_t inputCount_;
    std::vector<int> joinedInto_;                 // by vertex of the input; -1: none
    std::vector<Copy> copies_;                    // of the joined imprint's new vertices
    std::map<std::pair<int, int>, int> doubled_;  // by vertices of the surface and the input
};

}  // namespace

ImprintedMesh unjoined(const Surface& surface, const ImprintedMesh& joined) {
    return surface.provenance().hasSeams() ? Unjoiner(surface, joined).run() : joined;
}

}  // namespace bspline_curve
