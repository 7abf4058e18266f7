// SPDX-License-Identifier: GPL-3.0-or-later
#include "imprint/imprint_nodes.h"

#include "surface/surface_point.h"

#include <algorithm>
#include <cmath>

namespace bspline_curve {

double onGrid(double share) {
    constexpr double kCells = 0x1p52;
    return std::nearbyint(share * kCells) / kCells;
}

int ImprintNodes::edgeOf(int face, int k) const {
    const int next = surface_.faceNeighbours()[face][k];
    if (next < 0 || next > face) {
        return 3 * face + k;
    }
    // The corner of the neighbour that is not on the side; two faces may share two sides.
    const int first = surface_.faces()[face][(k + 1) % 3];
    const Triangle& other = surface_.faces()[next];
    return 3 * next + (cornerOf(other, first) + 1) % 3;
}

std::array<int, 2> ImprintNodes::facesOfEdge(int edge) const {
    return {edge / 3, surface_.faceNeighbours()[edge / 3][edge % 3]};
}

int ImprintNodes::addAtVertex(int vertex) {
    int& node = atVertex_.at(vertex, -1);
    if (node < 0) {
        node = count();
        nodes_.push_back({.on = ImprintNode::On::Vertex, .element = vertex});
    }
    return node;
}

int ImprintNodes::addOnEdge(int face, int k, double share) {
    const int edge = edgeOf(face, k);
    const auto [first, second] = facesOfEdge(edge);
    const double snap = second < 0 ? snap_.in(first) : std::max(snap_.in(first), snap_.in(second));
    const double fromStart = onGrid(edge == 3 * face + k ? share : 1.0 - share);
    if (fromStart <= snap || fromStart >= 1.0 - snap) {
        const int corner = (edge % 3 + (fromStart < 0.5 ? 1 : 2)) % 3;
        return addAtVertex(surface_.faces()[edge / 3][corner]);
    }
    Shares& shares = onEdge_[edge];
    for (auto near = shares.lower_bound(fromStart - snap);
         near != shares.end() && near->first <= fromStart + snap;
         ++near) {
        return near->second;
    }
    shares.emplace(fromStart, count());
    nodes_.push_back(
        {.on = ImprintNode::On::Edge, .element = edge, .place = FacePlace(fromStart, 0.0, 0.0)}
    );
    return count() - 1;
}

int ImprintNodes::add(int face, const Vec3& barycentric) {
    // What is an edge or a vertex for the rest of the library is one here, too.
    const double snap = std::max(snap_.in(face), kOnEdgeBarycentric);
    Eigen::Index smallest = 0;
    Eigen::Index largest = 0;
    barycentric.minCoeff(&smallest);
    barycentric.maxCoeff(&largest);
    if (barycentric[largest] >= 1.0 - snap) {
        return addAtVertex(surface_.faces()[face][largest]);
    }
    if (barycentric[smallest] <= snap) {
        const auto k = static_cast<int>(smallest);
        const double before = barycentric[(k + 1) % 3];
        const double after = barycentric[(k + 2) % 3];
        return addOnEdge(face, k, after / (before + after));
    }
    const FacePlace place(onGrid(barycentric[1]), onGrid(barycentric[2]), 0.0);
    Shares& places = inFace_[face];
    for (auto near = places.lower_bound(place.x() - snap);
         near != places.end() && near->first <= place.x() + snap;
         ++near) {
        if (std::abs(nodes_[near->second].place.y() - place.y()) <= snap) {
            return near->second;
        }
    }
    places.emplace(place.x(), count());
    nodes_.push_back({.on = ImprintNode::On::Face, .element = face, .place = place});
    return count() - 1;
}

bool ImprintNodes::isOnSide(int node, int face, int k) const {
    const ImprintNode& at = nodes_[node];
    switch (at.on) {
        case ImprintNode::On::Vertex: {
            const int corner = cornerOf(surface_.faces()[face], at.element);
            return corner >= 0 && corner != k;
        }
        case ImprintNode::On::Edge:
            return at.element == edgeOf(face, k);
        case ImprintNode::On::Face:
            return false;
    }
    return false;
}

int ImprintNodes::commonSide(int a, int b, int face) const {
    for (int k = 0; k < 3; ++k) {
        if (isOnSide(a, face, k) && isOnSide(b, face, k)) {
            return k;
        }
    }
    return -1;
}

bool ImprintNodes::isIn(int node, int face) const {
    const ImprintNode& at = nodes_[node];
    return at.on == ImprintNode::On::Face ? at.element == face : commonSide(node, node, face) >= 0;
}

FacePlace ImprintNodes::placeIn(int node, int face) const {
    constexpr std::array<std::array<double, 2>, 3> kCorners{{{0, 0}, {1, 0}, {0, 1}}};
    const auto corner = [&](int k) { return FacePlace(kCorners.at(k)[0], kCorners.at(k)[1], 0.0); };
    const ImprintNode& at = nodes_[node];
    switch (at.on) {
        case ImprintNode::On::Vertex:
            return corner(cornerOf(surface_.faces()[face], at.element));
        case ImprintNode::On::Edge: {
            int k = 0;
            while (edgeOf(face, k) != at.element) {
                ++k;
            }
            const bool isSame = at.element == 3 * face + k;
            const double share = isSame ? at.place.x() : 1.0 - at.place.x();
            return (1.0 - share) * corner((k + 1) % 3) + share * corner((k + 2) % 3);
        }
        case ImprintNode::On::Face:
            return at.place;
    }
    return at.place;
}

std::vector<int> ImprintNodes::onSide(int face, int k) const {
    std::vector<int> nodes;
    const int edge = edgeOf(face, k);
    const auto found = onEdge_.find(edge);
    if (found != onEdge_.end()) {
        for (const auto& [share, node] : found->second) {
            nodes.push_back(node);
        }
    }
    if (edge != 3 * face + k) {
        std::ranges::reverse(nodes);
    }
    return nodes;
}

std::vector<int> ImprintNodes::inside(int face) const {
    std::vector<int> nodes;
    const auto found = inFace_.find(face);
    if (found != inFace_.end()) {
        for (const auto& [x, node] : found->second) {
            nodes.push_back(node);
        }
    }
    return nodes;
}

std::vector<int> ImprintNodes::allIn(int face) {
    std::vector<int> nodes = inside(face);
    for (int k = 0; k < 3; ++k) {
        const std::vector<int> side = onSide(face, k);
        nodes.insert(nodes.end(), side.begin(), side.end());
        nodes.push_back(addCorner(face, k));
    }
    return nodes;
}

SurfacePoint ImprintNodes::surfacePoint(int node) const {
    const ImprintNode& at = nodes_[node];
    int face = at.element;
    if (at.on == ImprintNode::On::Vertex) {
        face = *surface_.facesAround(at.element).begin();
    } else if (at.on == ImprintNode::On::Edge) {
        face = at.element / 3;
    }
    const FacePlace place = placeIn(node, face);
    return {.face = face, .barycentric = Vec3(1.0 - place.x() - place.y(), place.x(), place.y())};
}

Vec3 ImprintNodes::position(int node) const {
    const ImprintNode& at = nodes_[node];
    return at.on == ImprintNode::On::Vertex ? surface_.vertices()[at.element]
                                            : surface_.position(surfacePoint(node));
}

std::vector<int> ImprintNodes::dividedEdges() const {
    std::vector<int> edges;
    for (const auto& [edge, shares] : onEdge_) {
        edges.push_back(edge);
    }
    return edges;
}

}  // namespace bspline_curve
