// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/mesh.h"
#include "spline/spline_space.h"

#include <cstddef>
#include <span>
#include <vector>

namespace bspline_curve {

/// The shape F of a path of least bending, by parameter. With one a spline P is not bent as little
/// as may be, but as F is: E_int (4) is of P - strength F, and
///   strength stiffness / 2 sum_j share_j |P(t_j) - F(t_j)|^2
/// holds it near the path. Both are quadratic. Empty: E_int is of P.
struct FairedShape {
    struct Point {
        double parameter = 0.0;
        double share = 0.0;  ///< of [0, 1] that the point stands for; 0 at picks
        Vec3 position = Vec3::Zero();
        Vec3 second = Vec3::Zero();  ///< F''
    };

    std::vector<Point> points;  ///< ascending from 0 to 1; closed: ends where it starts
    double stiffness = 0.0;
    double strength = 1.0;  ///< in (0, 1]
    /// What changes of E_int are measured against: about E_int of the path.
    double energy = 0.0;

    [[nodiscard]] bool empty() const { return points.empty(); }

    struct Derivatives {
        Vec3 first, second;
    };

    /// F' of a segment, and F'' linear between its ends, both times the strength; 0 without points.
    /// O(log n).
    [[nodiscard]] Derivatives at(double parameter) const;
};

/// The points of a shape by the spans of a spline that is held near to it.
class HeldPoints {
public:
    HeldPoints(const FairedShape& shape, const SplineSpace& space);

    struct Point {
        double tau;        ///< in [0, 1] on the span
        double stiffness;  ///< times the point's share
        Vec3 position;
        SplineSpace::BasisValues basis;
    };

    [[nodiscard]] std::span<const Point> of(int span) const {
        return std::span(points_).subspan(first_[span], first_[span + 1] - first_[span]);
    }

private:
    std::vector<Point> points_;       // by span
    std::vector<std::size_t> first_;  // of each span, and the end
};

}  // namespace bspline_curve
