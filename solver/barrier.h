// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <numbers>

namespace bspline_curve {

/// The barrier g_h (11): x -> c x tan(c x) with c = pi / (2 h), for |x| < h. Even, convex, smooth,
/// 0 at 0, infinite at h. Returns the value and its first two derivatives: g' = c tan + c^2 x
/// sec^2, g'' = 2 c^2 sec^2 (1 + c x tan).
struct Barrier {
    double value, slope, curvature;
};

[[nodiscard]] inline Barrier barrier(double x, double width) {
    const double c = std::numbers::pi / (2.0 * width);
    const double tangent = std::tan(c * x);
    const double secant2 = 1.0 + tangent * tangent;
    return {
        c * x * tangent,
        c * (tangent + c * x * secant2),
        2.0 * c * c * secant2 * (1.0 + c * x * tangent)
    };
}

[[nodiscard]] inline double barrierValue(double x, double width) {
    const double c = std::numbers::pi / (2.0 * width);
    return c * x * std::tan(c * x);
}

/// The barrier of what a curve avoids: x -> x^2 / (1 - x) for 0 <= x < 1. Convex, 0 at 0 with its
/// slope, infinite at 1, and so is its integral along any curve that touches there, even at a
/// corner. Its value and its first two derivatives: 1 / (1 - x)^2 - 1, 2 / (1 - x)^3.
[[nodiscard]] inline Barrier avoidanceBarrier(double x) {
    const double inverse = 1.0 / (1.0 - x);
    const double square = inverse * inverse;
    return {x * x * inverse, square - 1.0, 2.0 * square * inverse};
}

}  // namespace bspline_curve
