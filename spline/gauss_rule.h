// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace bspline_curve {

/// Gauss-Legendre rule with three points on [0, 1]: exact up to degree 5. With two points line
/// searches stall at a decrement of 1e-7 of the energy, since the exact gradient of the integrand
/// is not that of the sum when pieces change; with three at 1e-9 or not at all, for 15 % more.
inline constexpr std::array<double, 3> kGaussNodes = {
    0.11270166537925831, 0.5, 0.88729833462074169
};
inline constexpr std::array<double, 3> kGaussWeights = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};

/// Two Gauss points on each of the M even segments of a span (14)-(16).
inline constexpr std::array<double, 2> kPairNodes = {0.21132486540518712, 0.78867513459481288};

/// tau of sample i of the 2 M on a span.
[[nodiscard]] inline double sampleParameter(int i, int segments) {
    const int segment = i / 2;
    return (segment + kPairNodes[i % 2]) / segments;
}

}  // namespace bspline_curve
