// SPDX-License-Identifier: GPL-3.0-or-later
#include "imprint/imprint_nodes.h"

#include "surface/surface_point.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace bspline_curve {

namespace {

/// Rounds a barycentric coordinate, or a share of an edge, to a multiple of 2^-52.
double onGrid(double share) {
    constexpr double kCells = 0x1p52;
    return std::nearbyint(share * kCells) / kCells;
}

FacePlace cornerPlace(int k) {
    return {k == 1 ? 1.0 : 0.0, k == 2 ? 1.0 : 0.0, 0.0};
}

}  // namespace

std::span<const ImprintNodes::Share> ImprintNodes::Lists::at(int element) const {
    const int* list = listOf_.find(element);
    return list != nullptr ? std::span<const Share>(lists_[*list]) : std::span<const Share>();
}

template <class Near>
int ImprintNodes::Lists::find(int element, double share, double snap, const Near& isNear) const {
    const std::span<const Share> list = at(element);
    for (auto near = std::ranges::lower_bound(list, share - snap, {}, &Share::share);
         near != list.end() && near->share <= share + snap;
         ++near) {
        if (isNear(near->node)) {
            return near->node;
        }
    }
    return -1;
}

void ImprintNodes::Lists::insert(int element, Share share) {
    const int index = listOf_.at(element, static_cast<int>(lists_.size()));
    if (index == static_cast<int>(lists_.size())) {
        lists_.emplace_back();
    }
    std::vector<Share>& list = lists_[index];
    list.insert(std::ranges::upper_bound(list, share.share, {}, &Share::share), share);
}

int ImprintNodes::edgeOf(int face, int k) const {
    const int next = surface_.faceNeighbours()[face][k];
    if (next < 0 || next > face) {
        return 3 * face + k;
    }
    // By the vertices, since two faces may share two sides.
    const int first = surface_.faces()[face][(k + 1) % 3];
    return 3 * next + (cornerOf(surface_.faces()[next], first) + 1) % 3;
}

std::array<int, 2> ImprintNodes::facesOfEdge(int edge) const {
    return {edge / 3, surface_.faceNeighbours()[edge / 3][edge % 3]};
}

int ImprintNodes::append(const ImprintNode& node, Lists& lists) {
    lists.insert(node.element, {node.place.x(), count()});
    nodes_.push_back(node);
    return count() - 1;
}

int ImprintNodes::addOnEdge(int face, int k, double share) {
    const int edge = edgeOf(face, k);
    const auto [first, second] = facesOfEdge(edge);
    const double snap = second < 0 ? snap_.in(first) : std::max(snap_.in(first), snap_.in(second));
    const double fromStart = onGrid(edge == 3 * face + k ? share : 1.0 - share);
    if (fromStart <= snap || fromStart >= 1.0 - snap) {
        const int corner = (edge % 3 + (fromStart < 0.5 ? 1 : 2)) % 3;
        return ~surface_.faces()[edge / 3][corner];
    }
    const int near = onEdge_.find(edge, fromStart, snap, [](int) { return true; });
    if (near >= 0) {
        return near;
    }
    return append(
        {.on = ImprintNode::On::Edge, .element = edge, .place = FacePlace(fromStart, 0.0, 0.0)},
        onEdge_
    );
}

int ImprintNodes::add(int face, const Vec3& barycentric) {
    // What is an edge or a vertex for the rest of the library is one here, too.
    const double snap = std::max(snap_.in(face), kOnEdgeBarycentric);
    Eigen::Index smallest = 0;
    Eigen::Index largest = 0;
    barycentric.minCoeff(&smallest);
    barycentric.maxCoeff(&largest);
    if (barycentric[largest] >= 1.0 - snap) {
        return ~surface_.faces()[face][largest];
    }
    if (barycentric[smallest] <= snap) {
        const auto k = static_cast<int>(smallest);
        const double before = barycentric[(k + 1) % 3];
        const double after = barycentric[(k + 2) % 3];
        return addOnEdge(face, k, after / (before + after));
    }
    const FacePlace place(onGrid(barycentric[1]), onGrid(barycentric[2]), 0.0);
    const int near = inFace_.find(face, place.x(), snap, [&](int node) {
        return std::abs(nodes_[node].place.y() - place.y()) <= snap;
    });
    if (near >= 0) {
        return near;
    }
    return append({.on = ImprintNode::On::Face, .element = face, .place = place}, inFace_);
}

/// The sides of a face that hold a node, bit k for the one opposite to corner k.
unsigned ImprintNodes::sidesOf(int node, int face) const {
    if (node < 0) {
        const int corner = cornerOf(surface_.faces()[face], ~node);
        constexpr unsigned kAll = 7;
        return kAll & ~(1U << static_cast<unsigned>(corner));
    }
    const ImprintNode& at = nodes_[node];
    unsigned sides = 0;
    for (unsigned k = 0; k < 3 && at.on == ImprintNode::On::Edge; ++k) {
        sides |= edgeOf(face, static_cast<int>(k)) == at.element ? 1U << k : 0U;
    }
    return sides;
}

int ImprintNodes::commonSide(int a, int b, int face) const {
    const unsigned sides = sidesOf(a, face) & sidesOf(b, face);
    return sides == 0 ? -1 : std::countr_zero(sides);
}

FacePlace ImprintNodes::placeIn(int node, int face) const {
    if (node < 0) {
        return cornerPlace(cornerOf(surface_.faces()[face], ~node));
    }
    const ImprintNode& at = nodes_[node];
    if (at.on == ImprintNode::On::Face) {
        return at.place;
    }
    const int k = std::countr_zero(sidesOf(node, face));
    const double share = at.element == 3 * face + k ? at.place.x() : 1.0 - at.place.x();
    return (1.0 - share) * cornerPlace((k + 1) % 3) + share * cornerPlace((k + 2) % 3);
}

void ImprintNodes::appendOnSide(int face, int k, std::vector<int>& nodes) const {
    const int edge = edgeOf(face, k);
    const std::size_t before = nodes.size();
    for (const Share& share : onEdge_.at(edge)) {
        nodes.push_back(share.node);
    }
    if (edge != 3 * face + k) {
        std::reverse(nodes.begin() + static_cast<std::ptrdiff_t>(before), nodes.end());
    }
}

void ImprintNodes::appendInside(int face, std::vector<int>& nodes) const {
    for (const Share& share : inFace_.at(face)) {
        nodes.push_back(share.node);
    }
}

SurfacePoint ImprintNodes::surfacePoint(int node) const {
    const ImprintNode& at = nodes_[node];
    const int face = at.on == ImprintNode::On::Edge ? at.element / 3 : at.element;
    return {.face = face, .barycentric = barycentricAt(placeIn(node, face))};
}

Vec3 ImprintNodes::position(int node) const {
    return node < 0 ? surface_.vertices()[~node] : surface_.position(surfacePoint(node));
}

}  // namespace bspline_curve
