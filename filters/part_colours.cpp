// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/part_colours.h"

#include <algorithm>
#include <cmath>

namespace bspline_curve {

std::array<std::uint8_t, 3> partColour(int part) {
    constexpr double kGoldenShare = 0.618033988749895;  // of the circle of hues
    constexpr double kFirstHue = 0.58;                  // blue
    constexpr double kLow = 95.0;                       // of the channels, for soft colours
    constexpr double kHigh = 235.0;
    const double turns = kFirstHue + kGoldenShare * part;
    const double hue = 6.0 * (turns - std::floor(turns));
    std::array<std::uint8_t, 3> colour{};
    for (int channel = 0; channel < 3; ++channel) {
        // Distance of the hue from the channel's own, on a circle of length 6.
        const double apart = std::abs(hue - 2.0 * channel);
        const double share = std::clamp(2.0 - std::min(apart, 6.0 - apart), 0.0, 1.0);
        colour.at(channel) = static_cast<std::uint8_t>(std::lround(kLow + (kHigh - kLow) * share));
    }
    return colour;
}

}  // namespace bspline_curve
