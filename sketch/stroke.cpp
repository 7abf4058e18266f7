// SPDX-License-Identifier: GPL-3.0-or-later
#include "sketch/stroke.h"

#include "surface/line_simplification.h"
#include "utility/index_sets.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace bspline_curve {
namespace {

/// Enough for a curve that looks like the stroke until the fitted one is there.
constexpr std::size_t kThinned = 12;

double distance(const SketchPick& a, const SketchPick& b) {
    return (a.position - b.position).norm();
}

int nearestPoint(const std::vector<Vec3>& points, const Vec3& to) {
    const auto nearest =
        std::ranges::min_element(points, {}, [&](const Vec3& p) { return (p - to).squaredNorm(); });
    return static_cast<int>(nearest - points.begin());
}

/// The points of a closed polyline from one to another, both included.
class Arc {
public:
    Arc(int first, int last, int count) : first_(first), last_(last), count_(count) {}

    [[nodiscard]] int size() const { return (last_ - first_ + count_) % count_ + 1; }

    [[nodiscard]] int at(int i) const { return (first_ + i) % count_; }

    /// How far along it a point is; none where it is not on it.
    [[nodiscard]] std::optional<int> placeOf(int point) const {
        const int place = (point - first_ + count_) % count_;
        return place < size() ? std::optional(place) : std::nullopt;
    }

    /// The sum of the squared distances of the line's points to the nearest of the arc's.
    [[nodiscard]] double farFrom(
        const std::vector<SketchPick>& line, const std::vector<Vec3>& points
    ) const {
        double sum = 0.0;
        for (const SketchPick& pick : line) {
            double least = std::numeric_limits<double>::infinity();
            for (int i = 0; i < size(); ++i) {
                least = std::min(least, (points[at(i)] - pick.position).squaredNorm());
            }
            sum += least;
        }
        return sum;
    }

private:
    int first_, last_, count_;
};

// The curve's picks on an arc of its polyline, in its order.
std::vector<SketchPick> picksOn(const SketchCurve& curve, const Arc& arc) {
    std::vector<std::pair<int, int>> found;
    const std::vector<int>& picks = curve.settled->polyline.picks;
    for (int i = 0; i < static_cast<int>(picks.size()); ++i) {
        if (const auto place = arc.placeOf(picks[i])) {
            found.emplace_back(*place, i);
        }
    }
    std::ranges::sort(found);
    std::vector<SketchPick> on;
    for (const auto& [place, pick] : found) {
        on.push_back(curve.picks[pick]);
    }
    return on;
}

SketchPick pointOf(const SurfacePolyline& line, int point) {
    return {line.surfacePoints[point], line.points[point], false};
}

// Without what lies beside the ends, where the hand came to the curve.
void setEnds(
    std::vector<SketchPick>& line, const SketchPick& first, const SketchPick& last, double reach
) {
    const auto isAway = [&](const SketchPick& pick) {
        return distance(pick, first) > reach && distance(pick, last) > reach;
    };
    const auto begin = std::ranges::find_if(line, isAway);
    line.erase(line.begin(), begin);
    while (!line.empty() && !isAway(line.back())) {
        line.pop_back();
    }
    line.insert(line.begin(), first);
    line.push_back(last);
}

}  // namespace

std::vector<SketchPick> Stroke::joined(const std::vector<SketchPick>& along) const {
    std::vector<SketchPick> picks = before;
    const auto count = static_cast<std::ptrdiff_t>(along.size());
    const std::ptrdiff_t first = hasFirst ? 0 : 1;
    const std::ptrdiff_t end = hasLast ? count : count - 1;
    if (first < end) {
        picks.insert(picks.end(), along.begin() + first, along.begin() + end);
    }
    picks.insert(picks.end(), after.begin(), after.end());
    return picks;
}

std::vector<SketchPick> Stroke::thinned() const {
    const std::size_t count = std::min(line.size(), kThinned);
    const std::size_t steps = closed ? count : count - 1;  // a closed one ends where it begins
    std::vector<SketchPick> picks;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t place = steps == 0 ? 0 : i * (line.size() - 1) / steps;
        picks.push_back(line[place]);
    }
    return picks;
}

std::vector<SketchPick> describing(
    const std::vector<SketchPick>& along, bool closed, double within
) {
    const auto count = static_cast<int>(along.size());
    constexpr int kLeastClosed = 4;
    if (count <= (closed ? kLeastClosed : 2)) {
        return along;
    }
    std::vector<int> kept = {0};
    if (closed) {  // which no chord describes
        for (int k = 1; k < kLeastClosed; ++k) {
            kept.push_back(k * count / kLeastClosed);
        }
    }
    for (int i = 1; i + 1 < count; ++i) {
        if (along[i].isCorner) {
            kept.push_back(i);
        }
    }
    kept.push_back(closed ? count : count - 1);
    sortUnique(kept);
    std::vector<Vec3> line;
    for (const SketchPick& pick : along) {
        line.push_back(pick.position);
    }
    if (closed) {
        line.push_back(line.front());
    }
    std::vector<SketchPick> picks;
    for (const int i : simplified(line, std::move(kept), within)) {
        if (i < count) {
            picks.push_back(along[i]);
        }
    }
    return picks;
}

std::optional<Stroke> strokeInto(
    const SketchCurve& curve, std::vector<SketchPick> line, double reach
) {
    if (!curve.settled || curve.settled->polyline.picks.size() != curve.picks.size() ||
        line.size() < 2) {
        return std::nullopt;
    }
    const SurfacePolyline& old = curve.settled->polyline;
    const auto count = static_cast<int>(old.points.size());
    int from = nearestPoint(old.points, line.front().position);
    int to = nearestPoint(old.points, line.back().position);
    if (from == to) {
        return std::nullopt;
    }
    const bool isBackwards = old.closed ? Arc(to, from, count).farFrom(line, old.points) <
                                              Arc(from, to, count).farFrom(line, old.points)
                                        : to < from;
    if (isBackwards) {
        std::ranges::reverse(line);
        std::swap(from, to);
    }
    Stroke stroke;
    if (old.closed) {
        stroke.before = picksOn(curve, Arc(to, from, count));
    } else {
        stroke.before = picksOn(curve, Arc(0, from, count));
        stroke.after = picksOn(curve, Arc(to, count - 1, count));
    }
    SketchPick first = pointOf(old, from);
    SketchPick last = pointOf(old, to);
    if (!stroke.before.empty() && distance(stroke.before.back(), first) <= reach) {
        first = stroke.before.back();
        stroke.hasFirst = false;
    }
    const std::vector<SketchPick>& behind = old.closed ? stroke.before : stroke.after;
    if (!behind.empty() && distance(behind.front(), last) <= reach) {
        last = behind.front();
        stroke.hasLast = false;
    }
    setEnds(line, first, last, reach);
    stroke.line = std::move(line);
    return stroke;
}

}  // namespace bspline_curve
