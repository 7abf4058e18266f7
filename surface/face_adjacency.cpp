// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/face_adjacency.h"

#include "surface/input_error.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

namespace bspline_curve {

// Notation: half-edge h = 3 f + k is the edge of face f opposite to its vertex k, directed from
// vertex k + 1 to vertex k + 2 (cyclic). The low and the high vertex of an edge are the smaller and
// the larger index.

namespace {

using Elements = std::vector<std::int64_t>;

constexpr int next(int k) {
    return k == 2 ? 0 : k + 1;
}

constexpr int previous(int k) {
    return k == 0 ? 2 : k - 1;
}

std::size_t index(int i) {
    return static_cast<std::size_t>(i);
}

int cornerOf(const Triangle& face, int k) {
    return face[index(k)];
}

int tailOf(const TriangleMesh& mesh, int halfEdge) {
    return cornerOf(mesh.faces[index(halfEdge / 3)], next(halfEdge % 3));
}

int headOf(const TriangleMesh& mesh, int halfEdge) {
    return cornerOf(mesh.faces[index(halfEdge / 3)], previous(halfEdge % 3));
}

int oppositeOf(const TriangleMesh& mesh, int halfEdge) {
    return cornerOf(mesh.faces[index(halfEdge / 3)], halfEdge % 3);
}

struct EdgeEntry {
    int highVertex;
    int halfEdge;
    auto operator<=>(const EdgeEntry&) const = default;
};

/// Calls visit(lowVertex, entries) once per undirected edge with all its half-edges, ascending.
template <class Visitor>
void forEachEdge(const TriangleMesh& mesh, const Visitor& visit) {
    const auto halfEdgeCount = static_cast<int>(3 * mesh.faces.size());

    // Step 1: bucket the half-edges by their low vertex (counting sort).
    std::vector<int> offsets(mesh.vertices.size() + 1, 0);
    for (int h = 0; h < halfEdgeCount; ++h) {
        ++offsets[index(std::min(tailOf(mesh, h), headOf(mesh, h)))];
    }
    int end = 0;
    for (int& offset : offsets) {
        end += offset;
        offset = end;
    }
    // Filling from the back turns each end of a bucket into its start.
    std::vector<EdgeEntry> entries(index(halfEdgeCount));
    for (int h = halfEdgeCount - 1; h >= 0; --h) {
        const int low = std::min(tailOf(mesh, h), headOf(mesh, h));
        const int high = std::max(tailOf(mesh, h), headOf(mesh, h));
        entries[index(--offsets[index(low)])] = {.highVertex = high, .halfEdge = h};
    }

    // Step 2: sort each bucket by the high vertex; equal ones are one edge.
    for (std::size_t low = 0; low + 1 < offsets.size(); ++low) {
        const std::span<EdgeEntry> bucket(
            entries.data() + offsets[low], entries.data() + offsets[low + 1]
        );
        std::ranges::sort(bucket);
        for (std::size_t first = 0; first < bucket.size();) {
            std::size_t last = first + 1;
            while (last < bucket.size() && bucket[last].highVertex == bucket[first].highVertex) {
                ++last;
            }
            visit(static_cast<int>(low), bucket.subspan(first, last - first));
            first = last;
        }
    }
}

/// The edges with one kind of defect, and their faces.
struct BadEdges {
    std::size_t count = 0;
    Elements faces;

    void add(std::span<const EdgeEntry> edge) {
        ++count;
        for (const EdgeEntry& entry : edge) {
            faces.push_back(entry.halfEdge / 3);
        }
    }

    [[nodiscard]] Elements sortedFaces() const {
        Elements sorted = faces;
        std::ranges::sort(sorted);
        const auto repeated = std::ranges::unique(sorted);
        sorted.erase(repeated.begin(), repeated.end());
        return sorted;
    }
};

/// Position of a vertex in a face that has it.
int cornerIndex(const Triangle& face, int vertex) {
    if (face[0] == vertex) {
        return 0;
    }
    return face[1] == vertex ? 1 : 2;
}

struct Fan {
    bool isWhole;  ///< holds all faces at the vertex
    bool isOpen;
};

/// Writes a fan at a vertex over the list of the vertex's faces, which comes in ascending order: an
/// open fan if there is one, else the fan of the first face.
Fan orderFan(
    const TriangleMesh& mesh,
    const std::vector<Triangle>& neighbours,
    int vertex,
    std::span<int> facesAtVertex
) {
    // The face counter-clockwise of f around its corner k lies across the edge opposite to k + 1,
    // the face clockwise of it across the edge opposite to k + 2.
    const auto counterClockwise = [&](int face) {
        return cornerOf(
            neighbours[index(face)], next(cornerIndex(mesh.faces[index(face)], vertex))
        );
    };
    const auto clockwise = [&](int face) {
        return cornerOf(
            neighbours[index(face)], previous(cornerIndex(mesh.faces[index(face)], vertex))
        );
    };

    const auto firstOfOpenFan =
        std::ranges::find_if(facesAtVertex, [&](int face) { return clockwise(face) < 0; });
    const bool isOpen = firstOfOpenFan != facesAtVertex.end();
    const int start = isOpen ? *firstOfOpenFan : facesAtVertex.front();
    std::size_t size = 0;
    int face = start;
    do {
        facesAtVertex[size++] = face;
        face = counterClockwise(face);
    } while (face >= 0 && face != start);
    return {.isWhole = size == facesAtVertex.size(), .isOpen = isOpen};
}

}  // namespace

FaceAdjacency joinFacesAlongEdges(const TriangleMesh& mesh) {
    FaceAdjacency adjacency;
    adjacency.neighbours.assign(mesh.faces.size(), Triangle{-1, -1, -1});
    const auto link = [&](int halfEdge, int face) {
        adjacency.neighbours[index(halfEdge / 3)][index(halfEdge % 3)] = face;
    };

    std::size_t edgeCount = 0;
    double edgeLengthSum = 0.0;
    BadEdges crowded;
    BadEdges opposed;
    forEachEdge(mesh, [&](int low, std::span<const EdgeEntry> edge) {
        ++edgeCount;
        edgeLengthSum +=
            (mesh.vertices[index(low)] - mesh.vertices[index(edge[0].highVertex)]).norm();
        if (edge.size() == 1) {
            return;
        }
        const int g = edge[0].halfEdge;
        const int h = edge[1].halfEdge;
        if (edge.size() > 2 || oppositeOf(mesh, g) == oppositeOf(mesh, h)) {
            crowded.add(edge);
        } else if (tailOf(mesh, g) == tailOf(mesh, h)) {
            opposed.add(edge);
        } else {
            link(g, h / 3);
            link(h, g / 3);
        }
    });
    if (crowded.count > 0) {
        refuseElements(
            InputErrorCode::NonManifoldEdge,
            describeCount(crowded.count, "edge joins", "edges join") +
                " more than two faces, or two copies of one face",
            "faces",
            crowded.sortedFaces(),
            "remove some with MeshLab's filters 'Remove Duplicate Faces' and 'Repair non Manifold "
            "Edges'"
        );
    }
    if (opposed.count > 0) {
        refuseElements(
            InputErrorCode::InconsistentOrientation,
            describeCount(opposed.count, "edge joins", "edges join") +
                " faces that are turned opposite ways",
            "faces",
            opposed.sortedFaces(),
            "turn them with MeshLab's filter 'Re-Orient all faces coherently'; if that does not "
            "help, the mesh is one-sided like a Moebius strip, so cut it open first"
        );
    }
    adjacency.averageEdgeLength = edgeLengthSum / static_cast<double>(edgeCount);
    return adjacency;
}

VertexFans orderFacesAroundVertices(
    const TriangleMesh& mesh, const std::vector<Triangle>& neighbours
) {
    const std::size_t vertexCount = mesh.vertices.size();
    VertexFans fans;
    fans.offsets.assign(vertexCount + 1, 0);
    fans.faces.resize(3 * mesh.faces.size());
    fans.isBoundary.assign(vertexCount, 0);

    // Step 1: list the faces at every vertex, ascending (counting sort, filled from the back).
    for (const Triangle& face : mesh.faces) {
        for (const int vertex : face) {
            ++fans.offsets[index(vertex)];
        }
    }
    int end = 0;
    for (int& offset : fans.offsets) {
        end += offset;
        offset = end;
    }
    for (std::size_t f = mesh.faces.size(); f-- > 0;) {
        for (const int vertex : mesh.faces[f]) {
            fans.faces[index(--fans.offsets[index(vertex)])] = static_cast<int>(f);
        }
    }

    // Step 2: walk around every vertex.
    Elements bad;
    for (std::size_t v = 0; v < vertexCount; ++v) {
        const std::span<int> facesAtVertex(
            fans.faces.data() + fans.offsets[v], fans.faces.data() + fans.offsets[v + 1]
        );
        if (facesAtVertex.empty()) {
            continue;
        }
        const Fan fan = orderFan(mesh, neighbours, static_cast<int>(v), facesAtVertex);
        fans.isBoundary[v] = static_cast<char>(fan.isOpen);
        if (!fan.isWhole) {
            bad.push_back(static_cast<std::int64_t>(v));
        }
    }
    if (!bad.empty()) {
        refuseElements(
            InputErrorCode::NonManifoldVertex,
            describeCount(bad.size(), "vertex joins", "vertices join") +
                " parts of the surface that share no edge there",
            "vertices",
            bad,
            "split them with MeshLab's filter 'Repair non Manifold Vertices by splitting'"
        );
    }
    return fans;
}

FaceComponents labelComponents(const std::vector<Triangle>& neighbours) {
    FaceComponents components;
    components.componentOf.assign(neighbours.size(), -1);
    std::vector<int> pending;
    for (std::size_t seed = 0; seed < neighbours.size(); ++seed) {
        if (components.componentOf[seed] >= 0) {
            continue;
        }
        components.componentOf[seed] = components.count;
        pending.push_back(static_cast<int>(seed));
        while (!pending.empty()) {
            const int face = pending.back();
            pending.pop_back();
            for (const int neighbour : neighbours[index(face)]) {
                if (neighbour >= 0 && components.componentOf[index(neighbour)] < 0) {
                    components.componentOf[index(neighbour)] = components.count;
                    pending.push_back(neighbour);
                }
            }
        }
        ++components.count;
    }
    return components;
}

}  // namespace bspline_curve
