// SPDX-License-Identifier: GPL-3.0-or-later
#include "edit_bspline_curve/common/line_style.h"

#include <cmath>

namespace bspline_curve {
namespace {

// Colours that are lighter get a dark halo. The default, a red of 51, looks better with a light
// one.
constexpr double kDarkHaloFrom = 55.0;
constexpr double kEdgeAlpha = 0.8;

double linear(std::uint8_t channel) {
    const double value = channel / 255.0;
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

}  // namespace

double luminance(const SketchColour& colour) {
    return 0.2126 * linear(colour.red) + 0.7152 * linear(colour.green) +
           0.0722 * linear(colour.blue);
}

double lightness(const SketchColour& colour) {
    const double y = luminance(colour);
    return y > 216.0 / 24389.0 ? 116.0 * std::cbrt(y) - 16.0 : y * 24389.0 / 27.0;
}

LineStyle::LineStyle(const SketchColour& colour, const LineWidths& widths, double ratio)
    : colour_{colour},
      widths_{widths.line * ratio, widths.halo * ratio, widths.edge * ratio},
      ratio_(ratio) {
    const bool isLight = lightness(colour) > kDarkHaloFrom;
    halo_ = {isLight ? kDark : kLight, 1.0};
    edge_ = {isLight ? kLight : kDark, kEdgeAlpha};
}

void LineStyle::addLine(ScreenBatch& batch, const ScreenLine& line) const {
    batch.addStroke(line, widths_.edge, edge_);
    batch.addStroke(line, widths_.halo, halo_);
    batch.addStroke(line, widths_.line, colour_);
}

void LineStyle::addDot(ScreenBatch& batch, const ScreenNode& node, double radius) const {
    const double inner = radius * ratio_;
    batch.addDisc(node, inner + widths_.edge - widths_.line, edge_);
    batch.addDisc(node, inner + widths_.halo - widths_.line, halo_);
    batch.addDisc(node, inner, colour_);
}

}  // namespace bspline_curve
