// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/mesh_parsers.h"

#include <algorithm>

namespace bspline_curve {

void addFan(std::span<const int> corners, std::vector<Triangle>& faces) {
    for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
        faces.push_back({corners[0], corners[k], corners[k + 1]});
    }
}

bool sortAndFindRepeated(std::span<int> corners) {
    std::ranges::sort(corners);
    return std::ranges::adjacent_find(corners) != corners.end();
}

}  // namespace bspline_curve
