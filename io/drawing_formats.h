// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/drawing_builder.h"

#include <cstddef>
#include <string_view>

// What the formats of drawings share.
namespace bspline_curve {

/// Paths of a file, at most: elements and blocks that use others can ask for any number.
inline constexpr std::size_t kMostPaths = 1000000;

/// Draws path data ("M 0 0 L 1 1 …") as they are, y downwards. Throws std::invalid_argument saying
/// what is wrong at which character.
void drawSvgPath(std::string_view data, DrawingBuilder& pen);

/// The map of a list of transforms ("translate(1 2) rotate(30)"). Throws std::invalid_argument.
[[nodiscard]] Eigen::Affine2d svgTransform(std::string_view text);

}  // namespace bspline_curve
