// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/corridor_search.h"

#include <cmath>
#include <limits>
#include <span>

namespace bspline_curve {
namespace {

// Patches on each side of the way that belong to the corridor: one leaves out cheap ways.
constexpr int kRings = 2;
constexpr double kUnreached = std::numeric_limits<double>::infinity();

std::span<const int> neighboursOf(const PatchLevels::Level& level, int patch) {
    const int first = level.offsets[patch];
    return std::span(level.neighbours).subspan(first, level.offsets[patch + 1] - first);
}

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
    double least = kUnreached;
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
    queue_.clear();
    queue_.push({0.0, 0.0, start.patches[level]});
    arrivals_.at(start.patches[level], {0.0, -1});
    while (!queue_.empty()) {
        const Offer best = queue_.top();
        queue_.pop();
        if (best.place == goal.patches[level]) {
            explored_ += arrivals_.size();
            way_.clear();
            for (int patch = best.place; patch >= 0; patch = arrivals_.find(patch)->before) {
                way_.push_back(patch);
            }
            return true;
        }
        if (best.cost <= arrivals_.find(best.place)->cost) {
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
    const double costHere = costOf(level, from.place);
    const Vec3& here =
        from.place == start.patches[level] ? start.position : patches.centres[from.place];
    for (const int next : neighboursOf(patches, from.place)) {
        if (isInCorridor && !corridor_.contains(levels[level + 1].patchOf[next])) {
            continue;
        }
        const Vec3& there = next == goal.patches[level] ? goal.position : patches.centres[next];
        const double half = 0.5 * (there - here).norm();
        Arrival& arrival = arrivals_.at(next, {kUnreached, -1});
        if (from.cost + half * costHere >= arrival.cost) {
            continue;  // whatever it costs there
        }
        const double cost = from.cost + half * (costHere + costOf(level, next));
        if (cost < arrival.cost) {
            arrival = {cost, from.place};
            const double ahead = estimate * (goal.position - there).norm();
            queue_.push({cost + ahead, cost, next});
        }
    }
}

// The corridor becomes the way and what lies within kRings patches beside it.
void CorridorSearch::keepAround(std::size_t level) {
    const PatchLevels::Level& patches = patches_.levels()[level];
    corridor_.clear();
    std::vector<int> kept = way_;
    for (const int patch : way_) {
        corridor_.at(patch, 1);
    }
    std::size_t i = 0;
    for (int ring = 0; ring < kRings; ++ring) {
        for (const std::size_t end = kept.size(); i < end; ++i) {
            for (const int neighbour : neighboursOf(patches, kept[i])) {
                if (!corridor_.contains(neighbour)) {
                    corridor_.at(neighbour, 1);
                    kept.push_back(neighbour);
                }
            }
        }
    }
}

// A way through a patch with a narrow cheap valley can stay in the valley, so the cheap faces count
// most: the mean of order -3 of samples, infinite where all are closed.
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
