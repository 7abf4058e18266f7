// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

namespace bspline_curve {

/// Gauss-Legendre rule with three points on [0, 1]: exact up to degree 5. With two points line
/// searches stall at a decrement of 1e-7 of the energy, since the exact gradient of the integrand
/// is not that of the sum when pieces change; with three at 1e-9 or not at all, for 15 % more.
inline constexpr std::array<double, 3> kGaussNodes = {
    0.11270166537925831, 0.5, 0.88729833462074169
};
inline constexpr std::array<double, 3> kGaussWeights = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};

/// Two Gauss points on each of the even segments of a span.
inline constexpr std::array<double, 2> kPairNodes = {0.21132486540518712, 0.78867513459481288};

/// tau of sample i of the 2 on each segment of a span.
[[nodiscard]] inline double sampleParameter(int i, int segments) {
    const int segment = i / 2;
    return (segment + kPairNodes[i % 2]) / segments;
}

/// A point of a Gauss-Legendre rule on [0, 1].
struct GaussPoint {
    double node, weight;
};

inline constexpr int kMostGaussPoints = 4;

/// The rule with 1 to kMostGaussPoints points: exact up to degree 2 n - 1.
[[nodiscard]] inline std::span<const GaussPoint> gaussRule(int points) {
    static constexpr std::array<GaussPoint, 1> kOne{{{0.5, 1.0}}};
    static constexpr std::array<GaussPoint, 2> kTwo{{{kPairNodes[0], 0.5}, {kPairNodes[1], 0.5}}};
    static constexpr std::array<GaussPoint, 3> kThree{
        {{kGaussNodes[0], kGaussWeights[0]},
         {kGaussNodes[1], kGaussWeights[1]},
         {kGaussNodes[2], kGaussWeights[2]}}
    };
    static constexpr std::array<GaussPoint, 4> kFour{
        {{0.06943184420297371, 0.17392742256872693},
         {0.33000947820757187, 0.32607257743127307},
         {0.66999052179242813, 0.32607257743127307},
         {0.93056815579702629, 0.17392742256872693}}
    };
    switch (points) {
        case 1:
            return kOne;
        case 2:
            return kTwo;
        case 3:
            return kThree;
        default:
            return kFour;
    }
}

}  // namespace bspline_curve
