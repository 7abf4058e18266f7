// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/curve_formats.h"

namespace bspline_curve {

std::vector<std::pair<std::size_t, std::size_t>> segmentsOf(const SurfacePolyline& polyline) {
    std::vector<std::pair<std::size_t, std::size_t>> result;
    const std::size_t count = polyline.points.size();
    for (std::size_t i = 0; i + 1 < count; ++i) {
        result.emplace_back(i, i + 1);
    }
    if (polyline.closed && count > 1) {
        result.emplace_back(count - 1, 0);
    }
    return result;
}

std::vector<char> pickFlags(const SurfacePolyline& polyline) {
    std::vector<char> flags(polyline.points.size(), 0);
    for (const int vertex : polyline.picks) {
        flags[vertex] = 1;
    }
    return flags;
}

}  // namespace bspline_curve
