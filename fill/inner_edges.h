// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"
#include "surface/half_edges.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace bspline_curve {

/// An edge inside a patch, its faces (a, b, c) and (b, a, d).
struct InnerEdge {
    int a, b, c, d;
    int first, second;  ///< those faces
};

[[nodiscard]] inline std::vector<InnerEdge> innerEdges(const std::vector<Triangle>& faces) {
    std::vector<InnerEdge> edges;
    forEachEdge(sortedHalfEdges(faces), [&](std::span<const HalfEdge> sides) {
        if (sides.size() == 2) {
            const auto& [one, other] = std::array{sides[0], sides[1]};
            edges.push_back({
                .a = faces[one.face][(one.k + 1) % 3],
                .b = faces[one.face][(one.k + 2) % 3],
                .c = faces[one.face][one.k],
                .d = faces[other.face][other.k],
                .first = one.face,
                .second = other.face,
            });
        }
    });
    return edges;
}

/// Lets every face change once.
class ChangedFaces {
public:
    explicit ChangedFaces(std::size_t count) : isChanged_(count, 0) {}

    /// False where one of the faces has changed already.
    bool take(int first, int second) {
        if (isChanged_[first] != 0 || isChanged_[second] != 0) {
            return false;
        }
        isChanged_[first] = isChanged_[second] = 1;
        return true;
    }

private:
    std::vector<char> isChanged_;
};

}  // namespace bspline_curve
