// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/passages.h"

#include "surface/half_edges.h"
#include "utility/index_sets.h"
#include "utility/report_progress.h"

#include <algorithm>
#include <compare>
#include <functional>
#include <limits>
#include <queue>

namespace bspline_curve {

namespace {

/// Of a way over faces: the fewest partings crossed first, then the shortest.
struct WayCost {
    int partings = std::numeric_limits<int>::max();
    double length = 0.0;
    auto operator<=>(const WayCost&) const = default;
};

/// Dijkstra's search over the faces, and over the edges at which mending has parted some.
class WaysOverFaces {
public:
    WaysOverFaces(
        const Surface& mended, const std::vector<int>& vertexOrigins, const std::vector<int>& avoid
    )
        : mended_(mended),
          isAvoided_(mended.faces().size()),
          edgeAt_(3 * mended.faces().size(), -1) {
        for (const int face : avoid) {
            isAvoided_[face] = true;
        }
        forEachEdge(
            sortedHalfEdges(facesBeforeParting(mended.mesh(), vertexOrigins)),
            [&](std::span<const HalfEdge> edge) {
                const bool isParted =
                    edge.size() > 2 ||
                    (edge.size() == 2 &&
                     mended_.faceNeighbours()[edge[0].face][edge[0].k] != edge[1].face);
                if (isParted) {
                    addEdge(edge);
                }
            }
        );
    }

    /// Adds the passages of the best way; returns whether there is one.
    bool add(int from, int to, const Progress& progress) {
        search(from, to, progress);
        if (costs_[to].partings == WayCost().partings) {
            return false;
        }
        for (int node = to; node != from; node = parents_[node]) {
            const int edge = parents_[node] - mended_.faceCount();
            // Faces that were cut out of an edge of two find together again, see rejoined().
            if (edge >= 0 && facesAt_[edge].size() > 2) {
                passages_.emplace_back(std::minmax(parents_[parents_[node]], node));
            }
        }
        return true;
    }

    [[nodiscard]] std::vector<Passage> passages() && {
        sortUnique(passages_);
        return std::move(passages_);
    }

private:
    void addEdge(std::span<const HalfEdge> edge) {
        std::vector<int>& faces = facesAt_.emplace_back();
        for (const HalfEdge& halfEdge : edge) {
            faces.push_back(halfEdge.face);
            edgeAt_[3 * halfEdge.face + halfEdge.k] = static_cast<int>(facesAt_.size()) - 1;
        }
        Vec3 ends = Vec3::Constant(0.5);
        ends[edge.front().k] = 0.0;
        middles_.push_back(mended_.position({edge.front().face, ends}));
    }

    [[nodiscard]] Vec3 place(int node) const {
        if (node >= mended_.faceCount()) {
            return middles_[node - mended_.faceCount()];
        }
        return mended_.position({node, Vec3::Constant(1.0 / 3.0)});
    }

    void search(int from, int to, const Progress& progress) {
        constexpr int kNodesPerReport = 4096;
        const std::size_t nodes = mended_.faces().size() + facesAt_.size();
        costs_.assign(nodes, WayCost());
        parents_.assign(nodes, -1);
        queue_ = {};
        costs_[from] = {0, 0.0};
        queue_.emplace(costs_[from], from);
        for (int seen = 0; !queue_.empty() && queue_.top().second != to; ++seen) {
            if (seen % kNodesPerReport == 0) {
                report(progress, 0.0, "joining sheets");
            }
            const auto [cost, node] = queue_.top();
            queue_.pop();
            if (cost == costs_[node]) {
                leave(node);
            }
        }
    }

    void leave(int node) {
        if (node >= mended_.faceCount()) {
            for (const int face : facesAt_[node - mended_.faceCount()]) {
                reach(node, face, 1);
            }
            return;
        }
        for (int k = 0; k < 3; ++k) {
            if (const int neighbour = mended_.faceNeighbours()[node][k]; neighbour >= 0) {
                reach(node, neighbour, 0);
            }
            if (const int edge = edgeAt_[3 * node + k]; edge >= 0) {
                reach(node, mended_.faceCount() + edge, 0);
            }
        }
    }

    void reach(int from, int to, int partings) {
        if (to < mended_.faceCount() && isAvoided_[to]) {
            return;
        }
        const WayCost& before = costs_[from];
        const WayCost cost{
            before.partings + partings, before.length + (place(to) - place(from)).norm()
        };
        if (cost < costs_[to]) {
            costs_[to] = cost;
            parents_[to] = from;
            queue_.emplace(cost, to);
        }
    }

    using Entry = std::pair<WayCost, int>;

    const Surface& mended_;
    std::vector<bool> isAvoided_;
    std::vector<int> edgeAt_;                // 3 face + k: edge where faces are parted, or -1
    std::vector<std::vector<int>> facesAt_;  // of these edges
    std::vector<Vec3> middles_;              // likewise
    std::vector<WayCost> costs_;             // of nodes: faces, then edges
    std::vector<int> parents_;               // likewise
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
    std::vector<Passage> passages_;
};

}  // namespace

std::vector<Passage> passagesAt(
    std::span<const HalfEdge> edge, const std::vector<Passage>& passages
) {
    std::vector<Passage> found;
    for (const HalfEdge& low : edge) {
        for (auto next = std::ranges::lower_bound(passages, Passage(low.face, 0));
             next != passages.end() && next->first == low.face;
             ++next) {
            if (std::ranges::find(edge, next->second, &HalfEdge::face) != edge.end()) {
                found.push_back(*next);
            }
        }
    }
    return found;
}

std::vector<Triangle> facesBeforeParting(
    const TriangleMesh& mended, const std::vector<int>& vertexOrigins
) {
    std::vector<Triangle> faces = mended.faces;
    for (Triangle& face : faces) {
        for (int& v : face) {
            v = vertexOrigins[v];
        }
    }
    return faces;
}

std::vector<Passage> passagesBetween(
    const Surface& mended,
    const std::vector<int>& vertexOrigins,
    std::span<const int> faces,
    const std::vector<int>& avoid,
    const Progress& progress
) {
    WaysOverFaces ways(mended, vertexOrigins, avoid);
    const std::vector<int>& components = mended.faceComponents();
    for (std::size_t i = 0; i + 1 < faces.size(); ++i) {
        const bool isJoined = components[faces[i]] == components[faces[i + 1]];
        if (isJoined && avoid.empty()) {
            continue;
        }
        if (!ways.add(faces[i], faces[i + 1], stepOf(progress, i, faces.size() - 1))) {
            return {};
        }
    }
    return std::move(ways).passages();
}

}  // namespace bspline_curve
