// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "edit_bspline_curve/common/screen_batch.h"

namespace bspline_curve {

inline constexpr SketchColour kDark{20, 20, 20};
inline constexpr SketchColour kLight{255, 255, 255};

/// Luminance relative to white, from 0 to 1, as the Web Content Accessibility Guidelines define it.
[[nodiscard]] double luminance(const SketchColour& colour);

/// L* of CIELAB, from 0 to 100.
[[nodiscard]] double lightness(const SketchColour& colour);

/// Half widths of a line and of what lies beneath it, in logical pixels.
struct LineWidths {
    double line, halo, edge;
};

/// A line in its colour; beneath it a halo that is light under dark colours and dark under light
/// ones; and beneath that an edge, fainter and the other way round. So one of the three differs
/// from any surface.
class LineStyle {
public:
    LineStyle(const SketchColour& colour, const LineWidths& widths, double ratio);

    void addLine(ScreenBatch& batch, const ScreenLine& line) const;
    void addDot(ScreenBatch& batch, const ScreenNode& node, double radius) const;

private:
    Paint colour_, halo_, edge_;
    LineWidths widths_;  ///< device pixels
    double ratio_;
};

}  // namespace bspline_curve
