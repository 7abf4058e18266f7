// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/face_adjacency.h"

#include "surface/error_messages.h"
#include "utility/index_sets.h"
#include "utility/large_array.h"
#include "utility/worker_task.h"

#include <algorithm>
#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
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

/// A face at a vertex, seen from there.
struct Corner {
    int next;      ///< the face's vertex after this one
    int previous;  ///< and before it
    int face;
    int edge;  ///< of the face, from `previous` to here; across it lies the face counter-clockwise
};

Corner cornerAt(const TriangleMesh& mesh, int face, int vertex) {
    const Triangle& corners = mesh.faces[index(face)];
    // Without a branch, since which corner of a face a vertex is is past predicting.
    const int k =
        static_cast<int>(corners[1] == vertex) + 2 * static_cast<int>(corners[2] == vertex);
    return {
        .next = corners[index(next(k))],
        .previous = corners[index(previous(k))],
        .face = face,
        .edge = next(k),
    };
}

/// Puts the faces around one vertex in order; keeps its memory for the next vertex.
class FanOrder {
public:
    enum class Fan : char { Closed, Open, None };

    /// Puts corners in counter-clockwise order: an open fan from its first, a closed one from the
    /// corner that was first. None where they are not one fan, in which each edge joins two faces
    /// that use it in opposite directions and share no other, or bounds one.
    [[nodiscard]] Fan order(std::span<Corner> corners) {
        // Comparing each with each is quickest up to about so many.
        constexpr std::size_t kFewCorners = 24;
        if (corners.size() <= kFewCorners && chain(corners)) {
            return closed(corners);
        }
        return search(corners);
    }

private:
    /// A closed fan of two faces is a face and its copy.
    static Fan closed(std::span<const Corner> corners) {
        return corners.size() == 2 ? Fan::None : Fan::Closed;
    }

    /// Puts a closed fan in order, without memory; false where they are none.
    static bool chain(std::span<Corner> corners) {
        const std::size_t count = corners.size();
        const int begin = corners.front().next;
        for (std::size_t i = 0; i + 1 < count; ++i) {
            // Without leaving early, since where the next one is is past predicting.
            const int vertex = corners[i].previous;
            std::size_t successor = 0;
            int found = 0;
            for (std::size_t j = i + 1; j < count; ++j) {
                const bool follows = corners[j].next == vertex;
                successor = follows ? j : successor;
                found += static_cast<int>(follows);
            }
            if (found != 1 || vertex == begin) {
                return false;
            }
            std::swap(corners[i + 1], corners[successor]);
        }
        return corners.back().previous == begin;
    }

    /// Puts any fan in order, in O(n log n).
    Fan search(std::span<Corner> corners) {
        if (!findSuccessors(corners)) {
            return Fan::None;
        }
        const auto unfollowing = std::ranges::find(hasPredecessor_, 0);
        const bool isOpen = unfollowing != hasPredecessor_.end();
        const int first = isOpen ? static_cast<int>(unfollowing - hasPredecessor_.begin()) : 0;
        ordered_.clear();
        int corner = first;
        do {
            ordered_.push_back(corners[index(corner)]);
            corner = successors_[index(corner)];
        } while (corner >= 0 && corner != first && ordered_.size() < corners.size());
        if (ordered_.size() < corners.size() || corner != (isOpen ? -1 : first)) {
            return Fan::None;
        }
        std::ranges::copy(ordered_, corners.begin());
        return isOpen ? Fan::Open : closed(corners);
    }

    /// Finds the corner that leaves the vertex by the edge by which another comes, or -1; false
    /// where two leave by the same edge.
    bool findSuccessors(std::span<const Corner> corners) {
        using Leaving = std::pair<int, int>;
        leaving_.clear();
        for (std::size_t j = 0; j < corners.size(); ++j) {
            leaving_.emplace_back(corners[j].next, static_cast<int>(j));
        }
        std::ranges::sort(leaving_);
        if (std::ranges::adjacent_find(leaving_, {}, &Leaving::first) != leaving_.end()) {
            return false;
        }
        successors_.assign(corners.size(), -1);
        hasPredecessor_.assign(corners.size(), 0);
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const int vertex = corners[i].previous;
            const auto found = std::ranges::lower_bound(leaving_, vertex, {}, &Leaving::first);
            if (found != leaving_.end() && found->first == vertex) {
                successors_[i] = found->second;
                hasPredecessor_[index(found->second)] = 1;
            }
        }
        return true;
    }

    std::vector<std::pair<int, int>> leaving_;  // vertex after the corner, corner
    std::vector<int> successors_;
    std::vector<char> hasPredecessor_;
    std::vector<Corner> ordered_;
};

/// What joining finds at a range of vertices, beside what it writes.
struct RangeFindings {
    std::vector<double> edgeLengths;  ///< of the edges with low vertex in the range, by low, high
    std::vector<int> suspects;        ///< vertices whose faces are not one fan
};

/// Joins the faces at a range of vertices. Ranges may be joined at once: at a vertex only that is
/// written of its faces' neighbours which lies counter-clockwise around it.
class RangeJoin {
public:
    /// Orders adjacency.facesAround, and fills neighbours and isBoundary.
    RangeJoin(const TriangleMesh& mesh, FaceAdjacency& adjacency)
        : mesh_(mesh), adjacency_(adjacency) {}

    [[nodiscard]] RangeFindings join(int firstVertex, int lastVertex) {
        // An open fan has one edge more than faces. What is not used of the room is never touched.
        reserveLarge(
            findings_.edgeLengths,
            index(offset(lastVertex) - offset(firstVertex) + lastVertex - firstVertex)
        );
        // Block by block: loops that do little per vertex wait for several vertices' memory at
        // once, and the corners of a block stay in the cache.
        constexpr int kBlock = 128;
        for (int first = firstVertex; first < lastVertex; first += kBlock) {
            const int last = std::min(first + kBlock, lastVertex);
            gatherCorners(first, last);
            edgeCount_ = 0;
            for (int v = first; v < last; ++v) {
                joinAt(
                    v,
                    std::span(corners_).subspan(
                        index(offset(v) - offset(first)), index(offset(v + 1) - offset(v))
                    )
                );
            }
            measureEdges();
        }
        return std::move(findings_);
    }

private:
    struct Edge {
        int low;
        int high;
    };

    [[nodiscard]] int offset(int vertex) const {
        return adjacency_.facesAround.offsets[index(vertex)];
    }

    void gatherCorners(int first, int last) {
        corners_.resize(index(offset(last) - offset(first)));
        // An edge per corner, and one more at an open fan.
        edges_.resize(corners_.size() + index(last - first));
        const int* face = adjacency_.facesAround.faces.data() + offset(first);
        std::size_t filled = 0;
        for (int v = first; v < last; ++v) {
            for (const int end = offset(v + 1) - offset(first); filled < index(end); ++filled) {
                corners_[filled] = cornerAt(mesh_, *face++, v);
            }
        }
    }

    void joinAt(int vertex, std::span<Corner> corners) {
        if (corners.empty()) {
            return;
        }
        const FanOrder::Fan fan = fan_.order(corners);
        if (fan == FanOrder::Fan::None) {
            findings_.suspects.push_back(vertex);
            return;
        }
        const bool isOpen = fan == FanOrder::Fan::Open;
        adjacency_.isBoundary[index(vertex)] = static_cast<char>(isOpen);
        int* around = adjacency_.facesAround.faces.data() + offset(vertex);
        for (std::size_t i = 0; i < corners.size(); ++i) {
            around[i] = corners[i].face;
            neighbourAt(corners[i]) = corners[i + 1 < corners.size() ? i + 1 : 0].face;
        }
        if (isOpen) {
            neighbourAt(corners.back()) = -1;
        }
        listEdges(vertex, corners, isOpen);
    }

    [[nodiscard]] int& neighbourAt(const Corner& corner) {
        return adjacency_.neighbours[index(corner.face)][index(corner.edge)];
    }

    /// Lists the edges that have their low vertex here, by their high vertex.
    void listEdges(int vertex, std::span<const Corner> corners, bool isOpen) {
        const std::size_t first = edgeCount_;
        const auto list = [&](int other) {
            // Without a branch, since which of two vertices is the lower is past predicting.
            edges_[edgeCount_] = {.low = vertex, .high = other};
            edgeCount_ += static_cast<std::size_t>(other > vertex);
        };
        for (const Corner& corner : corners) {
            list(corner.next);
        }
        if (isOpen) {
            list(corners.back().previous);
        }
        std::ranges::sort(std::span(edges_).subspan(first, edgeCount_ - first), {}, &Edge::high);
    }

    void measureEdges() {
        for (const Edge& edge : std::span(edges_).first(edgeCount_)) {
            findings_.edgeLengths.push_back(
                (mesh_.vertices[index(edge.low)] - mesh_.vertices[index(edge.high)]).norm()
            );
        }
    }

    const TriangleMesh& mesh_;
    FaceAdjacency& adjacency_;
    RangeFindings findings_;
    FanOrder fan_;
    std::vector<Corner> corners_;
    std::vector<Edge> edges_;
    std::size_t edgeCount_ = 0;
};

struct EdgeEntry {
    int highVertex;
    int halfEdge;
    auto operator<=>(const EdgeEntry&) const = default;
};

/// Calls visit(entries) once per undirected edge that has its low vertex here, with all its
/// half-edges, ascending.
template <class Visitor>
void forEachEdgeAt(
    const TriangleMesh& mesh, int vertex, std::span<const int> faces, const Visitor& visit
) {
    std::vector<EdgeEntry> entries;
    for (const int face : faces) {
        const Corner corner = cornerAt(mesh, face, vertex);
        if (corner.previous > vertex) {
            entries.push_back({.highVertex = corner.previous, .halfEdge = 3 * face + corner.edge});
        }
        if (corner.next > vertex) {
            const int edge = next(corner.edge);
            entries.push_back({.highVertex = corner.next, .halfEdge = 3 * face + edge});
        }
    }
    std::ranges::sort(entries);
    for (std::size_t first = 0; first < entries.size();) {
        std::size_t last = first + 1;
        while (last < entries.size() && entries[last].highVertex == entries[first].highVertex) {
            ++last;
        }
        visit(std::span<const EdgeEntry>(entries).subspan(first, last - first));
        first = last;
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
        sortUnique(sorted);
        return sorted;
    }
};

int tailOf(const TriangleMesh& mesh, int halfEdge) {
    return mesh.faces[index(halfEdge / 3)][index(next(halfEdge % 3))];
}

int oppositeOf(const TriangleMesh& mesh, int halfEdge) {
    return mesh.faces[index(halfEdge / 3)][index(halfEdge % 3)];
}

/// Throws what is wrong with a mesh that has suspects: bad edges, which have both their vertices
/// among them, or, where no edge is bad, the vertices themselves.
[[noreturn]] void refuseSuspects(
    const TriangleMesh& mesh, const VertexFaces& facesAt, std::span<const int> suspects
) {
    BadEdges crowded;
    BadEdges opposed;
    const auto classify = [&](std::span<const EdgeEntry> edge) {
        if (edge.size() == 1) {
            return;
        }
        const int g = edge[0].halfEdge;
        const int h = edge[1].halfEdge;
        if (edge.size() > 2 || oppositeOf(mesh, g) == oppositeOf(mesh, h)) {
            crowded.add(edge);
        } else if (tailOf(mesh, g) == tailOf(mesh, h)) {
            opposed.add(edge);
        }
    };
    for (const int vertex : suspects) {
        const int first = facesAt.offsets[index(vertex)];
        const int last = facesAt.offsets[index(vertex) + 1];
        forEachEdgeAt(
            mesh,
            vertex,
            std::span(facesAt.faces).subspan(index(first), index(last - first)),
            classify
        );
    }
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
    refuseElements(
        InputErrorCode::NonManifoldVertex,
        describeCount(suspects.size(), "vertex joins", "vertices join") +
            " parts of the surface that share no edge there",
        "vertices",
        Elements(suspects.begin(), suspects.end()),
        "split them with MeshLab's filter 'Repair non Manifold Vertices by splitting'"
    );
}

/// First of the faces that a chain of smaller and smaller ones leads to; halves the chain.
int firstOf(std::vector<int>& smaller, int face) {
    while (smaller[index(face)] != face) {
        int& parent = smaller[index(face)];
        parent = smaller[index(parent)];
        face = parent;
    }
    return face;
}

}  // namespace

VertexFaces listFacesAtVertices(const TriangleMesh& mesh) {
    // A counting sort, filled from the back, which turns each end of a list into its start.
    VertexFaces listed;
    listed.offsets = makeLarge(mesh.vertices.size() + 1, 0);
    for (const Triangle& face : mesh.faces) {
        for (const int vertex : face) {
            ++listed.offsets[index(vertex)];
        }
    }
    int end = 0;
    for (int& offset : listed.offsets) {
        end += offset;
        offset = end;
    }
    listed.faces = makeLarge(3 * mesh.faces.size(), 0);
    for (std::size_t f = mesh.faces.size(); f-- > 0;) {
        for (const int vertex : mesh.faces[f]) {
            listed.faces[index(--listed.offsets[index(vertex)])] = static_cast<int>(f);
        }
    }
    return listed;
}

FaceAdjacency joinFaces(const TriangleMesh& mesh, VertexFaces listed) {
    FaceAdjacency adjacency;
    adjacency.neighbours = makeLarge(mesh.faces.size(), Triangle{});
    adjacency.isBoundary.resize(mesh.vertices.size());
    adjacency.facesAround = std::move(listed);

    // Step 1: join at the vertices, half of the corners on each thread.
    const std::vector<int>& offsets = adjacency.facesAround.offsets;
    const auto middle =
        static_cast<int>(std::ranges::lower_bound(offsets, offsets.back() / 2) - offsets.begin());
    const auto vertexCount = static_cast<int>(mesh.vertices.size());
    auto joinLater = startBeside(mesh.faces.size(), [&] {
        return RangeJoin(mesh, adjacency).join(middle, vertexCount);
    });
    const std::array<RangeFindings, 2> findings{
        RangeJoin(mesh, adjacency).join(0, middle), joinLater.get()
    };

    // Step 2: put together what they found, in order of the vertices.
    std::vector<int> suspects;
    double lengthSum = 0.0;
    std::size_t edgeCount = 0;
    for (const RangeFindings& found : findings) {
        suspects.insert(suspects.end(), found.suspects.begin(), found.suspects.end());
        for (const double length : found.edgeLengths) {
            lengthSum += length;
        }
        edgeCount += found.edgeLengths.size();
    }
    if (!suspects.empty()) {
        refuseSuspects(mesh, adjacency.facesAround, suspects);
    }
    adjacency.averageEdgeLength = lengthSum / static_cast<double>(edgeCount);
    return adjacency;
}

FaceComponents labelComponents(const std::vector<Triangle>& neighbours) {
    FaceComponents components;
    std::vector<int>& componentOf = components.componentOf;
    componentOf = makeLarge(neighbours.size(), 0);

    // Step 1: unite, in order of the faces; each leads to itself or to a smaller one of its
    // component, at last to the first.
    for (int face = 0; face < static_cast<int>(neighbours.size()); ++face) {
        int first = face;
        componentOf[index(face)] = face;
        for (const int neighbour : neighbours[index(face)]) {
            if (neighbour < 0 || neighbour > face) {
                continue;
            }
            const int other = firstOf(componentOf, neighbour);
            componentOf[index(std::max(first, other))] = std::min(first, other);
            first = std::min(first, other);
        }
    }

    // Step 2: number; the face that another leads to has its number already.
    for (int face = 0; face < static_cast<int>(neighbours.size()); ++face) {
        int& component = componentOf[index(face)];
        component = component == face ? components.count++ : componentOf[index(component)];
    }
    return components;
}

}  // namespace bspline_curve
