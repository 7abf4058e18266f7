// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "edit_bspline_curve/common/screen_line.h"

#include <vector>

namespace bspline_curve {

/// A whole number, from 0 on, as lines on the screen: no host has a font that is there for sure.
/// `centre`: of the number; `height` of its digits; both in device pixels.
[[nodiscard]] std::vector<ScreenLine> strokesOf(
    int number, const Eigen::Vector2d& centre, double height
);

}  // namespace bspline_curve
