// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/fitting_picks.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace bspline_curve {

namespace {

double squaredDistanceToSegment(const Vec3& point, const Vec3& from, const Vec3& to) {
    const Vec3 along = to - from;
    const double length = along.squaredNorm();
    const double t = length > 0.0 ? std::clamp((point - from).dot(along) / length, 0.0, 1.0) : 0.0;
    return (point - from - t * along).squaredNorm();
}

/// The vertices of a polyline, a closed one with its first at the end again.
class Simplifier {
public:
    explicit Simplifier(const SpacePolyline& line) : points_(line.points) {
        if (line.closed) {
            points_.push_back(line.points.front());
        }
    }

    [[nodiscard]] int last() const { return static_cast<int>(points_.size()) - 1; }

    /// The vertex between two others that is farthest from the segment between them, and the square
    /// of how far; -1 where there is none.
    [[nodiscard]] std::pair<int, double> farthest(int from, int to) const {
        std::pair<int, double> found(-1, 0.0);
        for (int i = from + 1; i < to; ++i) {
            const double distance =
                squaredDistanceToSegment(points_[i], points_[from], points_[to]);
            if (distance > found.second) {
                found = {i, distance};
            }
        }
        return found;
    }

    void simplify(int from, int to, double tolerance, std::vector<int>& kept) const {
        std::vector<std::pair<int, int>> waiting{{from, to}};
        while (!waiting.empty()) {
            const auto [a, b] = waiting.back();
            waiting.pop_back();
            const auto [vertex, squaredDistance] = farthest(a, b);
            if (vertex >= 0 && squaredDistance > tolerance * tolerance) {
                kept.push_back(vertex);
                waiting.emplace_back(a, vertex);
                waiting.emplace_back(vertex, b);
            }
        }
    }

private:
    std::vector<Vec3> points_;
};

}  // namespace

std::vector<int> fittingPicks(const SpacePolyline& line, double tolerance) {
    const Simplifier simplifier(line);
    const int last = simplifier.last();
    std::vector<int> kept{0};
    if (!line.closed) {
        kept.push_back(last);
        simplifier.simplify(0, last, tolerance, kept);
    } else if (const int opposite = simplifier.farthest(0, last).first; opposite > 0) {
        kept.push_back(opposite);
        simplifier.simplify(0, opposite, tolerance, kept);
        simplifier.simplify(opposite, last, tolerance, kept);
        if (kept.size() < 3) {
            // Flat to within the tolerance, but not to nothing.
            const auto one = simplifier.farthest(0, opposite);
            const auto other = simplifier.farthest(opposite, last);
            const auto& third = one.second > other.second ? one : other;
            if (third.first > 0) {
                kept.push_back(third.first);
            }
        }
    }
    std::ranges::sort(kept);
    return kept;
}

}  // namespace bspline_curve
