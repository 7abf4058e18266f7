// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

namespace bspline_curve {

/// The colour (red, green, blue) of a part by its number. Consecutive parts differ by the golden
/// angle in hue, so that few or many are told apart.
[[nodiscard]] std::array<std::uint8_t, 3> partColour(int part);

}  // namespace bspline_curve
