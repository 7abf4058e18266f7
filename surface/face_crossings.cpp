// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/face_crossings.h"

#include "surface/self_intersection.h"

namespace bspline_curve {

FaceCrossings::FaceCrossings(const Surface& surface, const TriangleTree& tree)
    : surface_(surface), tree_(tree), known_(surface.faces().size()) {}

// Threads that ask for one face at once find the same.
bool FaceCrossings::hasCrossing(int face) const {
    std::atomic<Known>& known = known_[face];
    if (known.load(std::memory_order_relaxed) == Known::Nothing) {
        known.store(findCrossing(face) ? Known::Crossing : Known::Clear, std::memory_order_relaxed);
    }
    return known.load(std::memory_order_relaxed) == Known::Crossing;
}

bool FaceCrossings::findCrossing(int face) const {
    bool isFound = false;
    const Triangle& corners = surface_.faces()[face];
    tree_.forEachOverlapping(face, [&](int other) {
        isFound =
            isFound || (other != face &&
                        trianglesIntersect(surface_.vertices(), corners, surface_.faces()[other]));
    });
    return isFound;
}

}  // namespace bspline_curve
