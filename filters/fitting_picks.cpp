// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/fitting_picks.h"

#include "surface/line_simplification.h"

#include <algorithm>

namespace bspline_curve {

std::vector<int> fittingPicks(const SpacePolyline& line, double tolerance) {
    const int last = static_cast<int>(line.points.size()) - 1;
    if (!line.closed) {
        return simplified(line.points, {0, last}, tolerance);
    }
    std::vector<Vec3> points = line.points;
    points.push_back(line.points.front());
    const int end = last + 1;
    const int opposite = farthestBetween(points, 0, end).first;
    if (opposite < 0) {
        return {0};
    }
    std::vector<int> kept = simplified(points, {0, opposite, end}, tolerance);
    kept.pop_back();  // the first again
    if (kept.size() < 3) {
        // Flat to within the tolerance, but not to nothing.
        const auto one = farthestBetween(points, 0, opposite);
        const auto other = farthestBetween(points, opposite, end);
        const auto& third = one.second > other.second ? one : other;
        if (third.first > 0) {
            kept.push_back(third.first);
            std::ranges::sort(kept);
        }
    }
    return kept;
}

}  // namespace bspline_curve
