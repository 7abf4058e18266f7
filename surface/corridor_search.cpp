// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/corridor_search.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace bspline_curve {
namespace {

// With one ring the ways came to be 12 % longer at worst than by a search of all faces, with two 1
// %.
constexpr int kRings = 2;
constexpr double kFar = std::numeric_limits<double>::infinity();

}  // namespace

CorridorSearch::CorridorSearch(
    const Surface& surface, const PatchLevels& patches, const TravelCosts& costs
)
    : surface_(surface), patches_(patches), costs_(costs), known_(patches.levels().size()) {}

CorridorSearch::Found CorridorSearch::find(
    const SurfacePoint& start, const SurfacePoint& goal, int mostPatches
) {
    const End from = endAt(start);
    const End to = endAt(goal);
    corridor_.clear();
    for (std::size_t level = patches_.levels().size(); level-- > 0;) {
        if (!findIn(level, from, to)) {
            return Found::Nothing;
        }
        if (static_cast<int>(way_.size()) > mostPatches) {
            levelOfWay_ = level;
            return Found::LongWay;
        }
        keepAround(level);
    }
    return patches_.levels().empty() ? Found::Nothing : Found::Corridor;
}

std::vector<SurfacePoint> CorridorSearch::pointsOnWay() const {
    std::vector<SurfacePoint> points;
    for (std::size_t i = way_.size() - 1; i-- > 1;) {
        points.push_back({centralFace(way_[i]), Vec3::Constant(1.0 / 3.0)});
    }
    return points;
}

// Of the faces that a patch on the long way is measured by, the one nearest to its centre.
int CorridorSearch::centralFace(int patch) const {
    const PatchLevels::Level& patches = patches_.levels()[levelOfWay_];
    int central = -1;
    double least = kFar;
    for (const int face : patches.samples[patch]) {
        if (face < 0) {
            continue;
        }
        const Vec3 centre = surface_.position({face, Vec3::Constant(1.0 / 3.0)});
        const double distance = (centre - patches.centres[patch]).squaredNorm();
        if (distance < least) {
            least = distance;
            central = face;
        }
    }
    return central;
}

CorridorSearch::End CorridorSearch::endAt(const SurfacePoint& point) const {
    End end{surface_.position(point), {}};
    int node = point.face;
    for (const PatchLevels::Level& level : patches_.levels()) {
        node = level.patchOf[node];
        end.patches.push_back(node);
    }
    return end;
}

bool CorridorSearch::findIn(std::size_t level, const End& start, const End& goal) {
    arrivals_.clear();
    queue_.assign(1, {0.0, 0.0, start.patches[level]});
    arrivals_.at(start.patches[level], {0.0, -1});
    while (!queue_.empty()) {
        std::ranges::pop_heap(queue_, std::greater<>());
        const Offer best = queue_.back();
        queue_.pop_back();
        if (best.patch == goal.patches[level]) {
            explored_ += arrivals_.size();
            way_.clear();
            for (int patch = best.patch; patch >= 0; patch = arrivals_.find(patch)->before) {
                way_.push_back(patch);
            }
            return true;
        }
        if (best.cost <= arrivals_.find(best.patch)->cost) {
            leave(best, level, start, goal);
        }
    }
    explored_ += arrivals_.size();
    return false;
}

// Offers the ways to the neighbours of a patch.
void CorridorSearch::leave(
    const Offer& from, std::size_t level, const End& start, const End& goal
) {
    const std::vector<PatchLevels::Level>& levels = patches_.levels();
    const PatchLevels::Level& patches = levels[level];
    const bool isInCorridor = level + 1 < levels.size();
    const double estimate = isInCorridor ? kCorridorEstimate * costs_.least : costs_.least;
    const double costHere = costOf(level, from.patch);
    const Vec3& here =
        from.patch == start.patches[level] ? start.position : patches.centres[from.patch];
    for (int i = patches.offsets[from.patch]; i < patches.offsets[from.patch + 1]; ++i) {
        const int next = patches.neighbours[i];
        if (isInCorridor && !corridor_.contains(levels[level + 1].patchOf[next])) {
            continue;
        }
        const Vec3& there = next == goal.patches[level] ? goal.position : patches.centres[next];
        const double half = 0.5 * (there - here).norm();
        Arrival& arrival = arrivals_.at(next, {kFar, -1});
        if (from.cost + half * costHere >= arrival.cost) {
            continue;  // whatever it costs there
        }
        const double cost = from.cost + half * (costHere + costOf(level, next));
        if (cost < arrival.cost) {
            arrival = {cost, from.patch};
            const double ahead = estimate * (goal.position - there).norm();
            queue_.push_back({cost + ahead, cost, next});
            std::ranges::push_heap(queue_, std::greater<>());
        }
    }
}

// The corridor becomes the way and what lies within kRings patches beside it.
void CorridorSearch::keepAround(std::size_t level) {
    const PatchLevels::Level& patches = patches_.levels()[level];
    corridor_.clear();
    std::vector<int> ring = way_;
    for (const int patch : way_) {
        corridor_.at(patch, 1);
    }
    for (int i = 0; i < kRings; ++i) {
        std::vector<int> next;
        for (const int patch : ring) {
            for (int k = patches.offsets[patch]; k < patches.offsets[patch + 1]; ++k) {
                if (!corridor_.contains(patches.neighbours[k])) {
                    corridor_.at(patches.neighbours[k], 1);
                    next.push_back(patches.neighbours[k]);
                }
            }
        }
        ring.swap(next);
    }
}

// A way through a patch with a narrow cheap valley can stay in the valley, so the cheap faces count
// most: the mean of order -3 of samples, infinite where all are closed. By the plain mean some ways
// in fields with sharp valleys came to cost 1.45 times as much as those by a search of all faces,
// by this 1.1 times.
double CorridorSearch::costOf(std::size_t level, int patch) {
    if (!costs_.ofFace) {
        return 1.0;
    }
    if (const double* cost = known_[level].find(patch)) {
        return *cost;
    }
    double sum = 0.0;
    int count = 0;
    for (const int face : patches_.levels()[level].samples[patch]) {
        if (face >= 0) {
            const double cost = costs_.ofFace(face);
            sum += 1.0 / (cost * cost * cost);
            ++count;
        }
    }
    return known_[level].at(patch, std::cbrt(count / sum));
}

}  // namespace bspline_curve
