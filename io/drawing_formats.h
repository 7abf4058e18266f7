// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bspline_curve/files.h"
#include "io/xml_tree.h"
#include "pattern/drawing_builder.h"

#include <cstddef>
#include <filesystem>
#include <string_view>

// The formats of drawings, one function each; readDrawing() chooses among them.
namespace bspline_curve {

/// Paths of a file, at most: elements and blocks that use others can ask for any number.
inline constexpr std::size_t kMostPaths = 1000000;

[[nodiscard]] DrawingFile drawingOfSvg(const std::filesystem::path& file, const XmlElement& root);

/// What curvesOfDxf() reads, seen along z; curves whose ends meet are one path.
[[nodiscard]] DrawingFile drawingOfDxf(
    const std::filesystem::path& file,
    std::string_view bytes,
    const std::vector<std::string>& layers
);

/// Draws path data ("M 0 0 L 1 1 …") as they are, y downwards. Throws std::invalid_argument saying
/// what is wrong at which character.
void drawSvgPath(std::string_view data, DrawingBuilder& pen);

/// The map of a list of transforms ("translate(1 2) rotate(30)"). Throws std::invalid_argument.
[[nodiscard]] Eigen::Affine2d svgTransform(std::string_view text);

}  // namespace bspline_curve
