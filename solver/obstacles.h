// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"
#include "shell/extended_surface.h"

#include <array>
#include <unordered_map>
#include <vector>

namespace bspline_curve {

/// A region of faces that a curve must not enter, and how close each point of the surface is to it.
///
/// The closeness J is continuous: 1 on the region with its edges, and falling with the distance
/// along the surface to 0 at the margin. It is affine in a face, except where an edge between two
/// faces beside the region has both ends on the region: there it is quadratic, and below 1 inside
/// that edge, so that a curve may pass wherever faces beside the region share an edge. Only in a
/// face that is no part of the region but all of whose neighbours are, J is 1 as well.
class Obstacles {
public:
    /// `margin`: in the user's unit, > 0.
    Obstacles(
        const Surface& surface, const ExtendedSurface& extended, const Region& region, double margin
    );

    /// Whether a face of the extended surface, ghosts included, belongs to the region.
    [[nodiscard]] bool isAvoided(int face) const { return kindOf(face) == Kind::Avoided; }

    /// Whether J is 0 all over a face.
    [[nodiscard]] bool isFar(int face) const { return kindOf(face) == Kind::Far; }

    [[nodiscard]] double closeness(const SurfacePoint& point) const;

    /// A point on the edge opposite to a corner of its face, moved along that edge until its
    /// clearance 1 - J is at least half of what the edge has at most.
    [[nodiscard]] SurfacePoint keptClear(const SurfacePoint& point, int opposite) const;

    /// Mean over a face of the surface of what a unit of length costs a path that keeps clear: 1
    /// where J is 0, infinite in the region.
    [[nodiscard]] double pathCost(int face) const;

    /// J in a face: the sum of corners[k] lambda_k and of bulges[k] lambda_(k + 1) lambda_(k + 2).
    struct FaceCloseness {
        std::array<double, 3> corners{};
        std::array<double, 3> bulges{};  ///< at most 0
        bool isBulging = false;          ///< whether there are any
    };

    [[nodiscard]] FaceCloseness onFace(int face) const;

private:
    enum class Kind : signed char { Far, Affine, Bulging, Avoided };

    using Bulges = std::array<double, 3>;

    [[nodiscard]] Kind kindOf(int face) const { return kinds_[face]; }

    [[nodiscard]] Bulges bulgesOf(int face) const {
        const auto found = bulges_.find(face);
        return found == bulges_.end() ? Bulges{} : found->second;
    }

    const ExtendedSurface& extended_;
    std::vector<double> values_;  // J at each vertex of the extended surface
    std::vector<Kind> kinds_;     // of each face of the extended surface
    std::unordered_map<int, Bulges> bulges_;
};

}  // namespace bspline_curve
