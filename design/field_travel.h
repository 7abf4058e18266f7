// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"

#include <cstddef>
#include <span>

namespace bspline_curve {

/// By how much a field makes paths through a face cost more.
struct FieldTravel {
    std::span<const double> vertexCosts;  ///< c at each vertex; empty: the field has no say
    double weight = 0.0;
    double least = 0.0;  ///< mean of c in the cheapest face

    [[nodiscard]] bool empty() const { return vertexCosts.empty(); }

    /// What a unit of length costs at a vertex: less than 1 where all faces around it cost more.
    [[nodiscard]] double costAt(int vertex) const {
        return 1.0 + weight * (vertexCosts[vertex] - least);
    }

    /// The same in a face, the mean of its corners: 1 in the cheapest.
    [[nodiscard]] double costOf(const Triangle& face) const {
        return (costAt(face[0]) + costAt(face[1]) + costAt(face[2])) / 3.0;
    }
};

}  // namespace bspline_curve
