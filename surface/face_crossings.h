// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "surface/surface.h"
#include "surface/triangle_tree.h"

#include <atomic>
#include <vector>

namespace bspline_curve {

/// Tells where a surface crosses itself, face by face, and remembers it: no more of the surface is
/// looked at than is asked for. Refers to what it is made from. Many threads may ask at once.
class FaceCrossings {
public:
    /// `tree`: over the faces of the surface. Takes a byte per face.
    FaceCrossings(const Surface& surface, const TriangleTree& tree);

    /// Whether a face meets another anywhere but in the corners and edges that they share (exact,
    /// see trianglesIntersect). About 3 us where it was not asked before.
    [[nodiscard]] bool hasCrossing(int face) const;

private:
    enum class Known : char { Nothing, Clear, Crossing };

    [[nodiscard]] bool findCrossing(int face) const;

    const Surface& surface_;
    const TriangleTree& tree_;
    mutable std::vector<std::atomic<Known>> known_;
};

}  // namespace bspline_curve
