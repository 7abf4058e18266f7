// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "design/fairing_node.h"

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace bspline_curve {

/// How a curve keeps to a pick, in the shell's frame: no farther from it than `bound`, and the
/// nearer the more `weight` times its squared distance costs. A bound of 0: it passes the pick.
struct PickLeeway {
    double bound = 0.0;   ///< >= 0, may be infinite
    double weight = 0.0;  ///< >= 0, in units of the energy per squared length
};

/// The picks that a polyline passes at a distance, each with the point of the polyline that is
/// nearest to it. They draw it by
///   sum_k weight_k d_k^2 + strength d_k^2 / (bound_k^2 - d_k^2)
/// where the barrier goes on as a parabola from shortly before the bound on: the polyline may come
/// from outside.
class NearPicks {
public:
    struct Pick {
        Vec3 position;
        PickLeeway leeway;
        std::size_t segment = 0;  ///< of the polyline, from its node of the same index
        double share = 0.0;       ///< of the segment
        bool isAtNode = false;    ///< stays at its end of the polyline, or at its seam
    };

    /// How much a pick draws its point y, for a distance d: the value of its term and the
    /// derivatives by d^2. `way`: from the pick to y, along the surface; d is its length.
    struct Pull {
        std::size_t segment;
        double share;
        Vec3 way;
        double value, slope, curvature;
    };

    void add(const Pick& pick) { picks_.push_back(pick); }

    [[nodiscard]] std::span<const Pick> picks() const { return picks_; }

    [[nodiscard]] std::span<Pick> picks() { return picks_; }

    [[nodiscard]] bool empty() const { return picks_.empty(); }

    /// Moves each point to the nearest one of the polyline that a descent from there finds. O(1)
    /// each where the polyline has moved little.
    void follow(std::span<const FairingNode> nodes, bool closed);

    /// Of the sum above.
    [[nodiscard]] double energy(std::span<const FairingNode> nodes, double strength) const;

    [[nodiscard]] Pull pullOf(
        const Pick& pick, std::span<const FairingNode> nodes, double strength
    ) const;

private:
    std::vector<Pick> picks_;
};

}  // namespace bspline_curve
