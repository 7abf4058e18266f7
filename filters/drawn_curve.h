// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/sketch.h"
#include "filters/drawn_options.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace bspline_curve {

/// Red, green, blue, opacity.
using CurveColour = std::array<std::uint8_t, 4>;

/// What a curve is drawn from, and how it is called and shown: all that is needed to draw it again.
struct DrawnCurve {
    std::vector<SketchPick> picks;
    DrawnOptions options;
    std::string name{};                   ///< UTF-8; empty: none
    std::optional<CurveColour> colour{};  ///< none: that of the host
};

}  // namespace bspline_curve
