// SPDX-License-Identifier: GPL-3.0-or-later
#include "bspline_curve/lines.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <tuple>
#include <utility>

namespace bspline_curve {
namespace {

/// An edge of a line, from `from` to `to` with the face of `left` on its left.
struct LineEdge {
    int from, to;
    int left, right;
    bool isTaken = false;
};

/// A side of a face.
struct FaceSide {
    int low, high;
    bool isUp;  // it goes from low to high
    int face;
};

std::vector<FaceSide> sortedSides(const TriangleMesh& mesh) {
    std::vector<FaceSide> sides;
    sides.reserve(3 * mesh.faces.size());
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        for (int k = 0; k < 3; ++k) {
            const int from = mesh.faces[f][k];
            const int to = mesh.faces[f][(k + 1) % 3];
            sides.push_back(
                {std::min(from, to), std::max(from, to), from < to, static_cast<int>(f)}
            );
        }
    }
    std::ranges::sort(sides, [](const FaceSide& a, const FaceSide& b) {
        return std::tie(a.low, a.high, a.face) < std::tie(b.low, b.high, b.face);
    });
    return sides;
}

// Edges of two faces, whatever their sides: on one that is turned over, left is that of the first.
std::vector<LineEdge> edgesBetween(const TriangleMesh& mesh, std::span<const int> labels) {
    const std::vector<FaceSide> sides = sortedSides(mesh);
    std::vector<LineEdge> edges;
    for (std::size_t i = 0; i + 1 < sides.size();) {
        std::size_t end = i + 1;
        while (end < sides.size() && sides[end].low == sides[i].low &&
               sides[end].high == sides[i].high) {
            ++end;
        }
        const int label = labels[sides[i].face];
        const int other = labels[sides[end - 1].face];
        if (end - i == 2 && label != other) {
            const auto& [low, high, isUp, face] = sides[i];
            edges.push_back({isUp ? low : high, isUp ? high : low, label, other});
        }
        i = end;
    }
    return edges;
}

class LineChainer {
public:
    LineChainer(std::vector<LineEdge> edges) : edges_(std::move(edges)) {
        for (std::size_t i = 0; i < edges_.size(); ++i) {
            around_[edges_[i].from].push_back(i);
            around_[edges_[i].to].push_back(i);
        }
    }

    [[nodiscard]] std::vector<BoundaryLine> chain() {
        std::vector<BoundaryLine> lines;
        for (const bool isOpen : {true, false}) {
            for (const auto& [vertex, edges] : around_) {
                for (const std::size_t edge : edges) {
                    if (!edges_[edge].isTaken && (!isOpen || isEnd(vertex))) {
                        lines.push_back(lineFrom(vertex, edge, isOpen));
                    }
                }
            }
        }
        return lines;
    }

private:
    // Where a line ends: labels change along it there, or others meet it.
    [[nodiscard]] bool isEnd(int vertex) const {
        const std::vector<std::size_t>& edges = around_.at(vertex);
        if (edges.size() != 2) {
            return true;
        }
        const auto labelsOf = [&](std::size_t i) {
            return std::minmax(edges_[i].left, edges_[i].right);
        };
        return labelsOf(edges[0]) != labelsOf(edges[1]);
    }

    [[nodiscard]] BoundaryLine lineFrom(int vertex, std::size_t edge, bool isOpen) {
        BoundaryLine line{.closed = !isOpen, .vertices = {vertex}};
        const LineEdge& first = edges_[edge];
        const bool isForward = first.from == vertex;
        line.left = isForward ? first.left : first.right;
        line.right = isForward ? first.right : first.left;
        for (std::size_t next = edge;;) {
            edges_[next].isTaken = true;
            const int last = line.vertices.back();
            const int here = edges_[next].from == last ? edges_[next].to : edges_[next].from;
            if (here == vertex && !isOpen) {
                return line;
            }
            line.vertices.push_back(here);
            if (isEnd(here)) {
                return line;
            }
            const std::vector<std::size_t>& edges = around_.at(here);
            next = edges_[edges[0]].isTaken ? edges[1] : edges[0];
        }
    }

    std::vector<LineEdge> edges_;
    std::map<int, std::vector<std::size_t>> around_;  // by vertex
};

}  // namespace

std::vector<BoundaryLine> boundaryLines(const TriangleMesh& mesh, std::span<const int> labels) {
    return LineChainer(edgesBetween(mesh, labels)).chain();
}

}  // namespace bspline_curve
