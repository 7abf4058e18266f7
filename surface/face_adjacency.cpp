// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/face_adjacency.h"

#include "bspline_curve/error.h"
#include "surface/half_edges.h"
#include "text/error_messages.h"
#include "utility/disjoint_sets.h"
#include "utility/index_sets.h"
#include "utility/large_array.h"
#include "utility/worker_task.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <string>
#include <utility>

namespace bspline_curve {

// The low and the high vertex of an edge are the smaller and the larger index.

namespace {

using Elements = std::vector<std::int64_t>;

constexpr int next(int k) {
    return k == 2 ? 0 : k + 1;
}

constexpr int previous(int k) {
    return k == 0 ? 2 : k - 1;
}

/// A face at a vertex, seen from there.
struct Corner {
    int next;      ///< the face's vertex after this one
    int previous;  ///< and before it
    int face;
    int edge;  ///< of the face, from `previous` to here; across it lies the face counter-clockwise
};

Corner cornerAt(const TriangleMesh& mesh, int face, int vertex) {
    const Triangle& corners = mesh.faces[face];
    // Without a branch, since which corner of a face a vertex is is past predicting.
    const int k =
        static_cast<int>(corners[1] == vertex) + 2 * static_cast<int>(corners[2] == vertex);
    return {
        .next = corners[next(k)],
        .previous = corners[previous(k)],
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
        byNext_.assign(corners.begin(), corners.end());
        std::ranges::sort(byNext_, {}, &Corner::next);
        if (std::ranges::adjacent_find(byNext_, {}, &Corner::next) != byNext_.end()) {
            return Fan::None;  // two leave the vertex by the same edge
        }
        previous_.clear();
        for (const Corner& corner : corners) {
            previous_.push_back(corner.previous);
        }
        std::ranges::sort(previous_);
        const auto first = std::ranges::find_if(corners, [this](const Corner& corner) {
            return !std::ranges::binary_search(previous_, corner.next);
        });
        const bool isOpen = first != corners.end();
        Corner corner = isOpen ? *first : corners.front();
        const int begin = corner.next;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            corners[i] = corner;
            const auto successor =
                std::ranges::lower_bound(byNext_, corner.previous, {}, &Corner::next);
            const bool isLast = i + 1 == corners.size();
            if (successor == byNext_.end() || successor->next != corner.previous) {
                return isOpen && isLast ? Fan::Open : Fan::None;
            }
            corner = *successor;
            if (corner.next == begin && !isLast) {
                return Fan::None;
            }
        }
        return isOpen ? Fan::None : closed(corners);
    }

    std::vector<Corner> byNext_;
    std::vector<int> previous_;
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
            offset(lastVertex) - offset(firstVertex) + lastVertex - firstVertex
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
                        offset(v) - offset(first), offset(v + 1) - offset(v)
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

    [[nodiscard]] int offset(int vertex) const { return adjacency_.facesAround.offsets[vertex]; }

    void gatherCorners(int first, int last) {
        corners_.resize(offset(last) - offset(first));
        // An edge per corner, and one more at an open fan.
        edges_.resize(corners_.size() + last - first);
        const int* face = adjacency_.facesAround.faces.data() + offset(first);
        std::size_t filled = 0;
        for (int v = first; v < last; ++v) {
            for (const std::size_t end = offset(v + 1) - offset(first); filled < end; ++filled) {
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
        adjacency_.isBoundary[vertex] = static_cast<char>(isOpen);
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
        return adjacency_.neighbours[corner.face][corner.edge];
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
                (mesh_.vertices[edge.low] - mesh_.vertices[edge.high]).norm()
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

/// The edges with one kind of defect, and their faces.
struct BadEdges {
    std::size_t count = 0;
    Elements faces;

    void add(std::span<const HalfEdge> edge) {
        ++count;
        for (const HalfEdge& halfEdge : edge) {
            faces.push_back(halfEdge.face);
        }
    }

    void refuse(InputErrorCode code, const std::string& what, const std::string& remedy) {
        if (count > 0) {
            sortUnique(faces);
            refuseElements(
                code,
                describeCount(count, "edge joins ", "edges join ") + what,
                "faces",
                std::move(faces),
                remedy
            );
        }
    }
};

/// Throws what is wrong with a mesh that has suspects: bad edges, or, where no edge is bad, the
/// vertices themselves.
[[noreturn]] void refuseSuspects(const TriangleMesh& mesh, const std::vector<int>& suspects) {
    BadEdges crowded;
    BadEdges opposed;
    forEachEdge(sortedHalfEdges(mesh.faces), [&](std::span<const HalfEdge> edge) {
        const auto apex = [&](std::size_t i) { return mesh.faces[edge[i].face][edge[i].k]; };
        if (edge.size() > 2 || (edge.size() == 2 && apex(0) == apex(1))) {
            crowded.add(edge);
        } else if (edge.size() == 2 && areParallel(mesh.faces, edge[0], edge[1])) {
            opposed.add(edge);
        }
    });
    crowded.refuse(
        InputErrorCode::NonManifoldEdge,
        "more than two faces, or two copies of one face",
        "leave two different ones at each"
    );
    opposed.refuse(
        InputErrorCode::InconsistentOrientation,
        "faces that are turned opposite ways",
        "turn some over, or cut the mesh open where it is one-sided like a Moebius strip"
    );
    refuseElements(
        InputErrorCode::NonManifoldVertex,
        describeCount(suspects.size(), "vertex joins", "vertices join") +
            " parts of the surface that share no edge there",
        "vertices",
        Elements(suspects.begin(), suspects.end()),
        "give each part a vertex of its own"
    );
}

}  // namespace

VertexFaces listFacesAtVertices(const TriangleMesh& mesh) {
    // A counting sort, filled from the back, which turns each end of a list into its start.
    VertexFaces listed;
    listed.offsets = makeLarge(mesh.vertices.size() + 1, 0);
    for (const Triangle& face : mesh.faces) {
        for (const int vertex : face) {
            ++listed.offsets[vertex];
        }
    }
    std::partial_sum(listed.offsets.begin(), listed.offsets.end(), listed.offsets.begin());
    listed.faces = makeLarge(3 * mesh.faces.size(), 0);
    for (std::size_t f = mesh.faces.size(); f-- > 0;) {
        for (const int vertex : mesh.faces[f]) {
            listed.faces[--listed.offsets[vertex]] = static_cast<int>(f);
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
        refuseSuspects(mesh, suspects);
    }
    adjacency.averageEdgeLength = lengthSum / static_cast<double>(edgeCount);
    return adjacency;
}

std::pair<std::vector<int>, int> labelComponents(const std::vector<Triangle>& neighbours) {
    DisjointSets sets(neighbours.size());
    for (int face = 0; face < static_cast<int>(neighbours.size()); ++face) {
        int lowest = face;
        for (const int neighbour : neighbours[face]) {
            if (neighbour >= 0 && neighbour < face) {
                lowest = sets.unite(lowest, neighbour);
            }
        }
    }
    return std::move(sets).numbered();
}

}  // namespace bspline_curve
