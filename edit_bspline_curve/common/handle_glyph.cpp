// SPDX-License-Identifier: GPL-3.0-or-later
#include "edit_bspline_curve/common/handle_glyph.h"

#include "edit_bspline_curve/common/line_style.h"
#include "edit_bspline_curve/common/stroke_digits.h"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace bspline_curve {
namespace {

constexpr SketchColour kHandle{255, 255, 255};
constexpr SketchColour kSelected{255, 191, 26};
constexpr SketchColour kHovered{255, 255, 102};
constexpr SketchColour kBad{230, 0, 0};

// Logical pixels.
constexpr double kDisc = 4.5;
constexpr double kDarkRim = 1.5, kLightRim = 1.0;
constexpr double kLarger = 1.25;  // hovered
constexpr double kRing = 10.0;
constexpr LineWidths kRingWidths{1.1, 2.1, 2.9};
constexpr double kSquare = 7.5;  // half its side
constexpr LineWidths kDirectionWidths{0.9, 1.9, 2.7};
constexpr double kDirectionDisc = 3.5;
constexpr double kCross = 12.0;
constexpr LineWidths kCrossWidths{1.3, 2.3, 3.1};
constexpr double kNumberHeight = 8.0, kNumberWidth = 0.75, kNumberHalo = 2.25;
constexpr double kNumberDistance = 17.0, kNumberDistanceLarge = 21.0;

ScreenNode beside(const ScreenNode& place, const Eigen::Vector2d& offset) {
    ScreenNode node;
    node.at = place.at + offset;
    return node;
}

ScreenLine circle(const ScreenNode& centre, double radius) {
    constexpr int kCorners = 32;
    ScreenLine line;
    line.closed = true;
    for (int i = 0; i < kCorners; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / kCorners;
        line.nodes.push_back(
            beside(centre, radius * Eigen::Vector2d(std::cos(angle), std::sin(angle)))
        );
    }
    return line;
}

ScreenLine square(const ScreenNode& centre, double half) {
    ScreenLine line;
    line.closed = true;
    for (const auto& [x, y] :
         {std::pair(1, 1), std::pair(-1, 1), std::pair(-1, -1), std::pair(1, -1)}) {
        line.nodes.push_back(beside(centre, half * Eigen::Vector2d(x, y)));
    }
    return line;
}

void addRimmedDisc(
    ScreenBatch& batch,
    const ScreenNode& place,
    double disc,
    const SketchColour& colour,
    double ratio
) {
    batch.addDisc(place, disc + ratio * (kDarkRim + kLightRim), {kLight});
    batch.addDisc(place, disc + ratio * kDarkRim, {kDark});
    batch.addDisc(place, disc, {colour});
}

SketchColour colourOf(const HandleState& state) {
    if (state.isBad) {
        return kBad;
    }
    if (state.isHovered) {
        return kHovered;
    }
    return state.isSelected ? kSelected : kHandle;
}

}  // namespace

void addHandle(
    ScreenBatch& batch, const ScreenNode& place, const HandleState& state, double ratio
) {
    if (state.isBad) {
        const LineStyle style(kBad, kCrossWidths, ratio);
        const double arm = ratio * kCross * std::numbers::sqrt2 / 2.0;
        for (const double up : {arm, -arm}) {
            style.addLine(batch, {{beside(place, {-arm, -up}), beside(place, {arm, up})}, false});
        }
    }
    if (state.isSelected) {
        LineStyle(kSelected, kRingWidths, ratio).addLine(batch, circle(place, ratio * kRing));
    }
    if (state.isCorner) {
        LineStyle(kHandle, kRingWidths, ratio).addLine(batch, square(place, ratio * kSquare));
    }
    const double disc = ratio * kDisc * (state.isHovered ? kLarger : 1.0);
    addRimmedDisc(batch, place, disc, colourOf(state), ratio);
}

void addDirection(
    ScreenBatch& batch, const ScreenNode& pick, const ScreenNode& end, bool isHovered, double ratio
) {
    ScreenLine line;
    line.nodes = {pick, end};
    LineStyle(kSelected, kDirectionWidths, ratio).addLine(batch, line);
    const double disc = ratio * kDirectionDisc * (isHovered ? kLarger : 1.0);
    addRimmedDisc(batch, end, disc, isHovered ? kHovered : kSelected, ratio);
}

void addHandleNumber(
    ScreenBatch& batch,
    const ScreenNode& place,
    const HandleState& state,
    const Eigen::Vector2d& direction,
    int number,
    double ratio
) {
    const bool isLarge = state.isSelected || state.isBad;
    const double distance = isLarge ? kNumberDistanceLarge : kNumberDistance;
    const std::vector<ScreenLine> strokes =
        strokesOf(number, place.at + ratio * distance * direction, ratio * kNumberHeight);
    for (const ScreenLine& stroke : strokes) {
        batch.addStroke(stroke, ratio * kNumberHalo, {kLight});
    }
    for (const ScreenLine& stroke : strokes) {
        batch.addStroke(stroke, ratio * kNumberWidth, {kDark});
    }
}

}  // namespace bspline_curve
