// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/strip_search.h"

#include "surface/surface_point.h"
#include "utility/index_sets.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace bspline_curve {
namespace {

constexpr double kNotYet = std::numeric_limits<double>::infinity();

}  // namespace

StripSearch::StripSearch(const Surface& surface, TravelCosts costs, const PatchLevels* patches)
    : surface_(surface), costs_(std::move(costs)) {
    if (patches != nullptr && !patches->levels().empty()) {
        corridor_.emplace(surface, *patches, costs_.costs());
    }
}

std::optional<StripSearch::Way> StripSearch::find(
    const SurfacePoint& start, const SurfacePoint& goal, int mostPatches
) {
    const Ends ends{
        start,
        goal,
        costs_.openFacesHolding(surface_, start),
        costs_.openFacesHolding(surface_, goal)
    };
    for (const int f : ends.startFaces) {
        if (contains(ends.goalFaces, f)) {
            return Way{{f}, {}};
        }
    }
    const std::vector<int>& components = surface_.faceComponents();
    if (components[start.face] != components[goal.face]) {
        return std::nullopt;
    }
    std::optional<Way> way;
    if (corridor_) {
        using Found = CorridorSearch::Found;
        const Found found = corridor_->find(start, goal, mostPatches);
        if (found == Found::LongWay) {
            return Way{{}, corridor_->pointsOnWay()};
        }
        if (found == Found::Corridor) {
            way = search(ends, Extent::Corridor);
        }
    }
    return way ? way : search(ends, Extent::Everywhere);
}

std::optional<StripSearch::Way> StripSearch::search(const Ends& ends, Extent extent) {
    explored_ += arrivals_.size();
    arrivals_.clear();
    queue_.clear();
    extent_ = extent;
    goal_ = surface_.position(ends.goal);
    for (const int f : ends.startFaces) {
        leave(f, surface_.position(ends.start), 0.0, -1);
    }
    while (!queue_.empty()) {
        const Offer best = queue_.top();
        queue_.pop();
        if (best.cost > arrivals_.find(edgeOf(best.place))->cost) {
            continue;  // found cheaper since
        }
        if (best.isWhole) {
            return Way{stripTo(best.place), {}};
        }
        const int face = faceBehind(best.place);
        const Vec3 from = middle(best.place);
        if (contains(ends.goalFaces, face)) {
            // The last leg may cost much, and a way into another of these faces less.
            const double whole = best.cost + costs_.of(face) * (goal_ - from).norm();
            queue_.push({whole, best.cost, best.place, true});
        }
        leave(face, from, best.cost, best.place);
    }
    return std::nullopt;
}

bool StripSearch::mayEnter(int face) {
    const bool isInside = extent_ == Extent::Everywhere || (corridor_ && corridor_->holds(face));
    return isInside && costs_.isOpen(face);
}

Vec3 StripSearch::middle(int crossing) const {
    const Triangle& face = surface_.faces()[crossing / 3];
    const int k = crossing % 3;
    return 0.5 * (surface_.vertices()[face[(k + 1) % 3]] + surface_.vertices()[face[(k + 2) % 3]]);
}

int StripSearch::faceBehind(int crossing) const {
    return surface_.faceNeighbours()[crossing / 3][crossing % 3];
}

// The smaller of the two crossings of an edge stands for it.
int StripSearch::edgeOf(int crossing) const {
    const int face = crossing / 3;
    const int behind = faceBehind(crossing);
    if (face < behind) {
        return crossing;
    }
    // Two faces may share two edges, so it is found by an end of the edge.
    const int end = surface_.faces()[face][(crossing % 3 + 1) % 3];
    return 3 * behind + (cornerOf(surface_.faces()[behind], end) + 1) % 3;
}

// Offers the ways out of a face, from a point of it.
void StripSearch::leave(int face, const Vec3& from, double cost, int before) {
    const double costHere = costs_.of(face);
    const double least = costs_.costs().least;
    const double estimate = extent_ == Extent::Corridor ? kCorridorEstimate * least : least;
    for (int k = 0; k < 3; ++k) {
        const int crossing = 3 * face + k;
        const int next = faceBehind(crossing);
        if (next < 0) {
            continue;
        }
        const Vec3 there = middle(crossing);
        const double costThere = cost + costHere * (there - from).norm();
        Arrival& arrival = arrivals_.at(edgeOf(crossing), {kNotYet, -1, -1});
        if (costThere < arrival.cost && mayEnter(next)) {
            arrival = {costThere, crossing, before};
            queue_.push({costThere + estimate * (goal_ - there).norm(), costThere, crossing});
        }
    }
}

std::vector<int> StripSearch::stripTo(int crossing) const {
    std::vector<int> strip{faceBehind(crossing)};
    for (int c = crossing; c >= 0; c = arrivals_.find(edgeOf(c))->before) {
        strip.push_back(c / 3);
    }
    std::ranges::reverse(strip);
    return strip;
}

}  // namespace bspline_curve
