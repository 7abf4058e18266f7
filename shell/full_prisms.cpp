// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/full_prisms.h"

#include "surface/surface_point.h"

#include <algorithm>

namespace bspline_curve {
Prism prismOver(const Triangle& face) {
    Prism prism;
    prism.pillars = face;
    std::ranges::sort(prism.pillars);
    for (std::size_t slot = 0; slot < 3; ++slot) {
        prism.faceCorner[slot] = static_cast<signed char>(cornerOf(face, prism.pillars[slot]));
    }
    prism.orientation = (prism.faceCorner[1] - prism.faceCorner[0] + 3) % 3 == 1 ? 1 : -1;
    prism.neighbours = {-1, -1, -1};
    return prism;
}

// Wall k is opposite to slot k, hence to corner faceCorner[k] of the face.
void connectPrisms(std::vector<Prism>& prisms, const std::vector<Triangle>& faceNeighbours) {
    for (std::size_t f = 0; f < prisms.size(); ++f) {
        Prism& prism = prisms[f];
        for (std::size_t slot = 0; prism.orientation != 0 && slot < 3; ++slot) {
            const int there = faceNeighbours[f][prism.faceCorner[slot]];
            if (there < 0 || prisms[there].orientation == 0) {
                continue;
            }
            prism.neighbours[slot] = there;
            const Prism& other = prisms[there];
            for (std::size_t k = 0; k < 3; ++k) {
                // Two faces may be neighbours across two edges.
                if (faceNeighbours[there][other.faceCorner[k]] == static_cast<int>(f) &&
                    other.pillars[k] != prism.pillars[(slot + 1) % 3] &&
                    other.pillars[k] != prism.pillars[(slot + 2) % 3]) {
                    prism.neighbourWalls[slot] = static_cast<signed char>(k);
                }
            }
        }
    }
}

}  // namespace bspline_curve
