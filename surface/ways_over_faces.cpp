// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/ways_over_faces.h"

#include "bspline_curve/progress.h"
#include "surface/surface_point.h"
#include "utility/index_sets.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace bspline_curve {

namespace {

/// Points on each edge that ways lead over: more on coarse meshes, where they cost little.
int pointsOnEdges(int faceCount) {
    constexpr int kFew = 2000;
    constexpr int kSome = 50000;
    return faceCount < kFew ? 9 : (faceCount < kSome ? 5 : 3);
}

}  // namespace

WaysOverFaces::WaysOverFaces(
    const Surface& surface, const PartedEdges& parted, std::span<const int> avoid
)
    : surface_(surface),
      parted_(parted),
      avoid_(avoid),
      pointsOnEdge_(pointsOnEdges(surface.faceCount())) {}

bool WaysOverFaces::mayEnter(int face) const {
    return !std::ranges::binary_search(avoid_, face);
}

// The parted edge that ways may cross at a side, or -1.
int WaysOverFaces::partedAt(int side) const {
    if (crossing_ == Crossing::Joined) {
        return -1;
    }
    const int edge = parted_.edgeAt(side);
    return edge >= 0 && parted_.edges()[edge].isSlit && crossing_ != Crossing::Slits ? -1 : edge;
}

// The sides that a way may go on to from a side of the face before.
std::vector<int> WaysOverFaces::sidesAcross(int side) const {
    if (const int edge = partedAt(side); edge >= 0) {
        std::vector<int> sides = parted_.edges()[edge].sides;
        std::erase(sides, side);
        return sides;
    }
    const int neighbour = surface_.faceNeighbours()[side / 3][side % 3];
    if (neighbour < 0) {
        return {};
    }
    const Triangle& there = surface_.faceNeighbours()[neighbour];
    // Two faces may be neighbours at two of their edges.
    const int from = surface_.faces()[side / 3][(side + 1) % 3];
    for (int k = 0; k < 3; ++k) {
        if (there[k] == side / 3 && surface_.faces()[neighbour][(k + 2) % 3] == from) {
            return {sideOf(neighbour, k)};
        }
    }
    return {};
}

// The same for all sides that a way may cross between.
int WaysOverFaces::edgeOf(int side) const {
    if (const int edge = partedAt(side); edge >= 0) {
        return parted_.edges()[edge].sides.front();
    }
    const std::vector<int> across = sidesAcross(side);
    return across.empty() ? side : std::min(side, across.front());
}

double WaysOverFaces::shareOf(int node) const {
    return (node % pointsOnEdge_ + 0.5) / pointsOnEdge_;
}

// A node lies at the same place on each side of its edge.
Vec3 WaysOverFaces::place(int side, int node) const {
    const Triangle& face = surface_.faces()[side / 3];
    const Vec3& a = surface_.vertices()[face[(side + 1) % 3]];
    const Vec3& b = surface_.vertices()[face[(side + 2) % 3]];
    const bool isLow = std::tie(a.x(), a.y(), a.z()) < std::tie(b.x(), b.y(), b.z());
    const double share = shareOf(node);
    return isLow ? Vec3(a + share * (b - a)) : Vec3(b + share * (a - b));
}

std::vector<int> WaysOverFaces::facesAt(const SurfacePoint& point) const {
    std::vector<int> faces = facesHolding(surface_, point);
    for (int k = 0; k < 3; ++k) {
        const int edge = partedAt(sideOf(point.face, k));
        if (edge >= 0 && point.barycentric[k] <= kOnEdgeBarycentric) {
            for (const int side : parted_.edges()[edge].sides) {
                faces.push_back(side / 3);
            }
        }
    }
    sortUnique(faces);
    std::erase_if(faces, [&](int face) { return !mayEnter(face); });
    return faces;
}

void WaysOverFaces::leave(int face, const Vec3& from, double cost, int before) {
    if (std::ranges::binary_search(goalFaces_, face)) {
        const double whole = cost + (goal_ - from).norm();
        if (whole <= longest_) {
            queue_.push({whole, whole, before, true});
        }
    }
    for (int k = 0; k < 3; ++k) {
        const int side = sideOf(face, k);
        const int first = edgeOf(side) * pointsOnEdge_;
        if (before >= first && before < first + pointsOnEdge_) {
            continue;
        }
        for (int node = first; node < first + pointsOnEdge_; ++node) {
            const Vec3 there = place(side, node);
            const double reached = cost + (there - from).norm();
            const double estimate = reached + (goal_ - there).norm();
            if (estimate > longest_) {
                continue;
            }
            Arrival& arrival = arrivals_.at(node, {});
            if (!arrival.isLeft && reached < arrival.cost) {
                arrival = {.cost = reached, .side = side, .before = before};
                queue_.push({estimate, reached, node});
            }
        }
    }
}

std::optional<FaceWay> WaysOverFaces::find(
    const SurfacePoint& start,
    const SurfacePoint& goal,
    Crossing crossing,
    double longest,
    const Progress& progress
) {
    constexpr int kNodesPerReport = 4096;
    constexpr int kMostNodes = 1000000;
    crossing_ = crossing;
    longest_ = longest;
    goal_ = surface_.position(goal);
    goalFaces_ = facesAt(goal);
    arrivals_.clear();
    queue_.clear();
    const Vec3 from = surface_.position(start);
    for (const int face : facesAt(start)) {
        leave(face, from, 0.0, -1);
    }
    for (int seen = 0; !queue_.empty(); ++seen) {
        if (seen % kNodesPerReport == 0) {
            report(progress, 0.0, "looking for ways");
        }
        if (seen > kMostNodes && std::isfinite(longest)) {
            return std::nullopt;
        }
        const Offer offer = queue_.top();
        queue_.pop();
        if (offer.isWhole) {
            return wayTo(offer.place, offer.cost);
        }
        Arrival& arrival = arrivals_.at(offer.place, {});
        if (arrival.isLeft) {
            continue;
        }
        arrival.isLeft = true;
        for (const int side : sidesAcross(arrival.side)) {
            if (mayEnter(side / 3)) {
                leave(side / 3, place(side, offer.place), offer.cost, offer.place);
            }
        }
    }
    return std::nullopt;
}

// The way whose last node is given, or -1: none.
FaceWay WaysOverFaces::wayTo(int node, double length) const {
    FaceWay way{.steps = {}, .length = length};
    for (int after = -1; node >= 0;) {
        const Arrival& arrival = *arrivals_.find(node);
        std::vector<int> sides = sidesAcross(arrival.side);
        const auto leadsOn = [&](int side) {
            return after < 0 ? std::ranges::binary_search(goalFaces_, side / 3) : side / 3 == after;
        };
        const int to = *std::ranges::find_if(sides, leadsOn);
        way.steps.push_back({arrival.side, to, shareOf(node), parted_.edgeAt(arrival.side)});
        after = arrival.side / 3;
        node = arrival.before;
    }
    std::ranges::reverse(way.steps);
    return way;
}

}  // namespace bspline_curve
